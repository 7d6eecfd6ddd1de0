// Sending a scene file to the server that a command talks to.
#pragma once

#include "connection.hpp"

namespace foothold::cli {

// The server's verdict, STORED or REFUSED. Throws Complaint: unreadable file, unknown ending, no answer.
msg::SceneStatus put_scene(const Connection& connection, const Common& common, const std::string& path, const std::string& name);

}  // namespace foothold::cli

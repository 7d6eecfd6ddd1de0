// What systemd is told, if it asked (NOTIFY_SOCKET): ready, reloading, stopping, still alive.
#pragma once

#include <string>

namespace foothold::server::service {

void ready(const std::string& status);
void reloading();  // until ready() is said again
void stopping();
void alive();  // from the loop that does the work: with every heartbeat

}  // namespace foothold::server::service

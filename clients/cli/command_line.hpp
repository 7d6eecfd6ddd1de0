// From arguments to a command that is ready to run.
#pragma once

#include <functional>

#include "command_help.hpp"
#include "commands.hpp"

namespace foothold::cli {

// The command, or, where the arguments ask for help or are wrong, one that does nothing but give the exit code: what there was to
// say has been printed.
std::function<Exit()> parse(int count, char** words);

}  // namespace foothold::cli

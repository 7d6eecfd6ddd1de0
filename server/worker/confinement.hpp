// What a worker process does to itself before it lets a plugin in: it dies with the daemon, leaves no core, is the kernel's first
// choice when memory is short, and says a last word when it crashes.
#pragma once

#include <sys/types.h>

#include <cstdint>

namespace foothold::server {

// Dies when the thread of `daemon` that made this process ends. False if the daemon is gone already.
bool tie_to(pid_t daemon);

// No core file, no new privileges, preferred by the kernel's out-of-memory killer. What the system does not allow is left as it is:
// none of these is needed for a right plan.
void confine();

// Bytes of address space; 0: none. Beyond it `new` throws std::bad_alloc. Not under sanitizers, whose shadow needs terabytes: there
// only the daemon watches. Throws std::system_error.
void limit_memory(std::uint64_t bytes);

// On SIGSEGV, SIGBUS, SIGFPE, SIGILL or SIGABRT: the signal, the address and a backtrace go to stderr, which the daemon keeps; then
// the signal takes its course. A plugin that installs its own handler replaces this one. Not under sanitizers, which have theirs.
void speak_last_words();

}  // namespace foothold::server

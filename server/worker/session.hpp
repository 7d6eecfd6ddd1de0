// A worker's life: LOAD, READY or REFUSED, then one plan after the other until the daemon closes the channel.
#pragma once

namespace foothold::server {

// Serves the daemon at the other end of this connected socket. Returns the process's exit code: 0 when the daemon closed the
// channel, the plugin was refused or memory ran out (all of which the daemon was told), 2 when the daemon spoke nonsense, 3
// when the system refused a thread, a descriptor or memory.
int serve(int socket);

}  // namespace foothold::server

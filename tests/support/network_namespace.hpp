// A network of the test's own: nothing leaves it, and two test programs that run at the same time do not hear each other.
#pragma once

namespace foothold::test {

// Moves this process, and all that it starts, into a new network namespace with only a loopback interface, which is up. Call it
// before the first thread and the first socket. False where the kernel does not allow it: then loopback and the domain id have to
// do.
bool enter_own_network();

}  // namespace foothold::test

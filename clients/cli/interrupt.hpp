// Ctrl-C and SIGTERM, noticed instead of obeyed at once. The second one ends the program.
#pragma once

namespace foothold::cli {

// Thread rule: main thread, once, before other threads start.
void watch_interrupts();
bool interrupted();

}  // namespace foothold::cli

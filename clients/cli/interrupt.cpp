// The handler only sets a flag; with SA_RESETHAND the second signal has its usual effect.
#include "interrupt.hpp"

#include <csignal>

namespace foothold::cli {
namespace {

volatile std::sig_atomic_t flag = 0;

void note(int) { flag = 1; }

}  // namespace

void watch_interrupts() {
  struct sigaction action {};
  action.sa_handler = note;
  action.sa_flags = SA_RESETHAND;
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

bool interrupted() { return flag != 0; }

}  // namespace foothold::cli

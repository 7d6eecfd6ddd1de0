// prctl, setrlimit, and a signal handler on a stack of its own.
#include "worker/confinement.hpp"

#include <execinfo.h>
#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <system_error>

namespace foothold::server {

bool tie_to(pid_t daemon) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  // The daemon may have died before the line above.
  return getppid() == daemon;
}

void confine() {
  const rlimit none{0, 0};
  setrlimit(RLIMIT_CORE, &none);
  prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
  const int file = open("/proc/self/oom_score_adj", O_WRONLY | O_CLOEXEC);
  if (file < 0) return;
  [[maybe_unused]] const ssize_t written = write(file, "500", 3);
  close(file);
}

#ifdef FOOTHOLD_SANITIZED

void limit_memory(std::uint64_t) {}
void speak_last_words() {}

#else

void limit_memory(std::uint64_t bytes) {
  if (bytes == 0) return;
  const rlimit limit{bytes, bytes};
  if (setrlimit(RLIMIT_AS, &limit) != 0) throw std::system_error(errno, std::generic_category(), "memory_limit");
}

namespace {

constexpr std::array kSignals = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};
// backtrace_symbols_fd needs about 10 kB.
alignas(16) std::array<char, 64 << 10> crash_stack;

void put(const char* text) { [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, text, strlen(text)); }

void put_hexadecimal(std::uintptr_t value) {
  std::array<char, 2 + 2 * sizeof(value) + 1> text{};
  std::size_t at = text.size() - 1;
  do {
    text[--at] = "0123456789abcdef"[value % 16];
    value /= 16;
  } while (value != 0);
  text[--at] = 'x';
  text[--at] = '0';
  put(text.data() + at);
}

// Async-signal-safe calls only; backtrace() is one once its library is loaded.
void last_words(int signal, siginfo_t* info, void*) {
  put("signal SIG");
  const char* name = sigabbrev_np(signal);
  put(name != nullptr ? name : "?");
  if (signal != SIGABRT) {
    put(" at address ");
    put_hexadecimal(reinterpret_cast<std::uintptr_t>(info->si_addr));
  }
  put("\n");
  std::array<void*, 12> frames{};  // of more lines the daemon keeps too few others
  const int depth = backtrace(frames.data(), frames.size());
  backtrace_symbols_fd(frames.data(), depth, STDERR_FILENO);
  // The handler is reset by now: a fault repeats itself on return, a signal that was sent has to be sent again.
  raise(signal);
}

}  // namespace

void speak_last_words() {
  std::array<void*, 1> first{};
  backtrace(first.data(), first.size());
  const stack_t stack{.ss_sp = crash_stack.data(), .ss_flags = 0, .ss_size = crash_stack.size()};
  sigaltstack(&stack, nullptr);
  struct sigaction action {};
  action.sa_sigaction = last_words;
  action.sa_flags = SA_SIGINFO | SA_ONSTACK | SA_RESETHAND;
  for (const int signal : kSignals) sigaction(signal, &action, nullptr);
}

#endif

}  // namespace foothold::server

// posix_spawn: unlike fork it does not copy the page tables of a daemon that holds two DDS participants.
#include "workers/process.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <system_error>
#include <utility>

extern char** environ;

namespace foothold::server {
namespace {

constexpr int kWorkerSocket = 3;

[[noreturn]] void fail(int error, const std::string& what) { throw std::system_error(error, std::generic_category(), what); }

// The child's descriptors: nothing on stdin, everything printed into the pipe, the socket, and no other.
class FileActions {
 public:
  FileActions(int socket, int words) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions_, words, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions_, words, STDERR_FILENO);
    posix_spawn_file_actions_adddup2(&actions_, socket, kWorkerSocket);
    posix_spawn_file_actions_addclosefrom_np(&actions_, kWorkerSocket + 1);
  }
  ~FileActions() { posix_spawn_file_actions_destroy(&actions_); }
  const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_{};
};

// A process group of its own, and signals as a fresh program expects them, whatever the daemon blocks or ignores.
class Attributes {
 public:
  Attributes() {
    posix_spawnattr_init(&attributes_);
    sigset_t signals;
    sigfillset(&signals);
    posix_spawnattr_setsigdefault(&attributes_, &signals);
    sigemptyset(&signals);
    posix_spawnattr_setsigmask(&attributes_, &signals);
    posix_spawnattr_setpgroup(&attributes_, 0);
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK);
  }
  ~Attributes() { posix_spawnattr_destroy(&attributes_); }
  const posix_spawnattr_t* get() const { return &attributes_; }

 private:
  posix_spawnattr_t attributes_{};
};

}  // namespace

OwnedFd& OwnedFd::operator=(OwnedFd&& other) noexcept {
  std::swap(fd_, other.fd_);
  return *this;
}
OwnedFd::~OwnedFd() {
  if (fd_ >= 0) ::close(fd_);
}
int OwnedFd::release() { return std::exchange(fd_, -1); }

Process spawn_worker(const std::string& program) {
  std::array<int, 2> sockets{}, pipe{};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, sockets.data()) != 0) fail(errno, "socketpair");
  Process process;
  process.socket = OwnedFd(sockets[0]);
  const OwnedFd their_socket(sockets[1]);
  if (pipe2(pipe.data(), O_CLOEXEC) != 0) fail(errno, "pipe");
  process.words = OwnedFd(pipe[0]);
  const OwnedFd their_words(pipe[1]);
  fcntl(process.words.get(), F_SETFL, O_NONBLOCK);

  std::string name = program, option = "--daemon", daemon = std::to_string(getpid());
  std::array<char*, 4> arguments = {name.data(), option.data(), daemon.data(), nullptr};
  const FileActions actions(their_socket.get(), their_words.get());
  const Attributes attributes;
  if (const int error = posix_spawn(&process.pid, program.c_str(), actions.get(), attributes.get(), arguments.data(), environ))
    fail(error, program);
  // glibc 2.36 declares pidfd_open() for C only.
  const int exit = static_cast<int>(syscall(SYS_pidfd_open, process.pid, 0));
  if (exit < 0) {
    const int error = errno;
    kill_group(process.pid);
    reap(process.pid);
    fail(error, "pidfd_open");
  }
  process.exit = OwnedFd(exit);
  return process;
}

void kill_group(pid_t pid) {
  // The leader too: in the instant before it has entered its group the first call finds nothing.
  ::kill(-pid, SIGKILL);
  ::kill(pid, SIGKILL);
}

std::optional<ProcessEnd> reap(pid_t pid) {
  int status = 0;
  while (waitpid(pid, &status, 0) < 0)
    if (errno != EINTR) return std::nullopt;
  if (WIFSIGNALED(status)) return ProcessEnd{true, WTERMSIG(status)};
  return ProcessEnd{false, WEXITSTATUS(status)};
}

std::optional<std::uint64_t> resident_memory(pid_t pid) {
  const std::string path = "/proc/" + std::to_string(pid) + "/statm";
  const OwnedFd file(open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.get() < 0) return std::nullopt;
  std::array<char, 128> text{};
  if (read(file.get(), text.data(), text.size() - 1) <= 0) return std::nullopt;
  unsigned long long pages = 0;
  if (std::sscanf(text.data(), "%*u %llu", &pages) != 1) return std::nullopt;
  return pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

}  // namespace foothold::server

// Starts, feeds and ends a peer process.
#include "peer.hpp"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <stdexcept>

namespace foothold::test {
namespace {

std::string beside_this_program(const std::string& name) {
  return (std::filesystem::read_symlink("/proc/self/exe").parent_path() / name).string();
}

}  // namespace

Peer::Peer(const std::vector<std::string>& command, Errors errors) {
  int in[2];
  int out[2];
  // Close on exec: a later child must not hold the ends of an earlier one open.
  if (pipe2(in, O_CLOEXEC) != 0 || pipe2(out, O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, in[0], STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, out[1], STDOUT_FILENO);
  if (errors == Errors::kHidden) posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  std::vector<std::string> words = command;
  const std::string program = beside_this_program(command.front());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  const int fault = posix_spawn(&pid_, program.c_str(), &actions, nullptr, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  close(in[0]);
  close(out[1]);
  to_ = in[1];
  from_ = out[0];
  if (fault != 0) throw std::runtime_error("cannot start " + program);
  signal(SIGPIPE, SIG_IGN);
  collector_ = std::thread([this] { collect(); });
}

Peer::~Peer() {
  if (pid_ > 0) finish();
  collector_.join();
  close(from_);
}

void Peer::collect() {
  while (auto frame = get_frame(from_)) {
    const std::lock_guard lock(mutex_);
    if (frame->kind == Kind::kMessage) ++message_count_;
    frames_.push_back(std::move(*frame));
    changed_.notify_all();
  }
  const std::lock_guard lock(mutex_);
  ended_ = true;
  changed_.notify_all();
}

bool Peer::send(std::span<const std::byte> message) { return put_frame(to_, Kind::kMessage, message); }

void Peer::kill_hard() {
  ::kill(pid_, SIGKILL);
  finish();
}

int Peer::finish() {
  if (pid_ <= 0) return status_;
  close(to_);
  const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  int status = 0;
  while (waitpid(pid_, &status, WNOHANG) == 0) {
    if (std::chrono::steady_clock::now() > until) ::kill(pid_, SIGKILL);
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  pid_ = -1;
  status_ = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  return status_;
}

bool Peer::wait(double seconds, const std::function<bool(const std::vector<Frame>&)>& enough) {
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, std::chrono::duration<double>(seconds), [&] { return ended_ || enough(frames_); });
  return enough(frames_);
}

bool Peer::wait_ready(double seconds) {
  return wait(seconds, [](const auto& frames) {
    return std::ranges::any_of(frames, [](const Frame& frame) { return frame.kind == Kind::kReady; });
  });
}

bool Peer::wait_number(Kind kind, std::uint64_t number, double seconds) {
  return wait(seconds, [&](const auto& frames) {
    const auto last = std::find_if(frames.rbegin(), frames.rend(), [&](const Frame& frame) { return frame.kind == kind; });
    return last != frames.rend() && last->number() == number;
  });
}

bool Peer::wait_messages(std::size_t count, double seconds) {
  return wait(seconds, [&](const auto&) { return message_count_ >= count; });
}

std::vector<std::vector<std::byte>> Peer::messages() {
  const std::lock_guard lock(mutex_);
  std::vector<std::vector<std::byte>> found;
  for (const Frame& frame : frames_) {
    if (frame.kind == Kind::kMessage) found.push_back(frame.octets);
  }
  return found;
}

}  // namespace foothold::test

// Newer workers in the place of older ones, which finish their runs.
#include <sys/stat.h>

#include <algorithm>

#include "workers/pool.hpp"

namespace foothold::server {
namespace {

// What changes when somebody puts another file in a file's place, or writes to it. Nothing if it is not there.
std::string stamp_of(const std::string& file) {
  struct stat found {};
  if (::stat(file.c_str(), &found) != 0) return {};
  std::string stamp;
  for (const auto part :
       {static_cast<long long>(found.st_dev), static_cast<long long>(found.st_ino), static_cast<long long>(found.st_size),
        static_cast<long long>(found.st_mtim.tv_sec), static_cast<long long>(found.st_mtim.tv_nsec)})
    stamp += std::to_string(part) + " ";
  return stamp;
}

}  // namespace

// Two files make a worker; what they were when the present generation began.
std::string Pool::file_stamps() const { return stamp_of(robot_.plugin) + "/" + stamp_of(program_); }

bool Pool::apply(RobotConfig robot, const WorkersConfig& limits, std::string program) {
  const frame::Load before = load_frame();
  const bool same_program = program == program_ && robot.slots == robot_.slots;
  robot_ = std::move(robot);
  config_ = limits;
  program_ = std::move(program);
  health_.set_limits(limits);
  described_.reset();
  const bool was_withdrawn = std::exchange(withdrawn_, false);
  if (!was_withdrawn && same_program && load_frame() == before && file_stamps() == loaded_ &&
      status().info->state() == msg::READY) {
    changed();  // its description may be another
    return false;
  }
  reload();
  return true;
}

void Pool::withdraw() {
  if (std::exchange(withdrawn_, true)) return;
  timer_.cancel();
  for (Member& member : members_) retire(member);
  settle();
  changed();
}

void Pool::reload() {
  say(log::Level::kInfo, "loading " + robot_.plugin + " anew");
  // Newer ones that are not ready yet would load a file that is out of date.
  for (Member& member : members_)
    if (!member.ready && !member.retiring) retire(member);
  ++generation_;
  loaded_ = file_stamps();
  refused_.reset();
  health_.forgive();
  owed_ = 0;
  settled_ = false;
  fill();
  settle();
  changed();
}

bool Pool::older_serve() const {
  return std::ranges::any_of(
      members_, [this](const Member& member) { return member.generation != generation_ && member.ready && !member.retiring; });
}

// So many older workers make room as newer ones are ready.
void Pool::retire_older(std::size_t most) {
  for (Member& member : members_) {
    if (most == 0) return;
    if (member.generation == generation_ || member.retiring) continue;
    retire(member);
    --most;
  }
}

// The plugin on disk is no good: those of before, which are, stay.
void Pool::give_up_reload(const msg::Error& reason) {
  say(log::Level::kError, "the newer plugin is not used, the one of before goes on: " + reason.message());
  for (Member& member : members_) {
    if (member.generation == generation_)
      retire(member);
    else if (!member.retiring)
      member.generation = generation_ + 1;
  }
  ++generation_;
  settle();
  changed();
}

}  // namespace foothold::server

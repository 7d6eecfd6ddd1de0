// What `foothold` exits with. The text of --help and of the manual page is made from this table.
#pragma once

#include <foothold.h>

#include <string_view>

namespace foothold::cli {

enum class Exit : int {
  kSucceeded = 0,
  kOther = 1,
  kUsage = 2,
  kPartial = 3,
  kFailed = 4,
  kCancelled = 5,
  kExpired = 6,
  kCrashed = 7,
  kRejected = 8,
  kNoServer = 9,
  kUnknownId = 10,
  kDiffers = 11,
  kInterrupted = 130,
};

struct ExitMeaning {
  Exit code;
  std::string_view meaning;
};

inline constexpr ExitMeaning kExitMeanings[] = {
    {Exit::kSucceeded, "SUCCEEDED, or the command did what it was asked to do"},
    {Exit::kOther, "something else went wrong; the message says what (doctor: something will not work)"},
    {Exit::kUsage, "wrong arguments, or a file that cannot be read"},
    {Exit::kPartial, "PARTIAL: sound steps, goal not reached"},
    {Exit::kFailed, "FAILED"},
    {Exit::kCancelled, "CANCELLED"},
    {Exit::kExpired, "EXPIRED: the budget ended"},
    {Exit::kCrashed, "CRASHED: the planner's process died"},
    {Exit::kRejected, "REJECTED, or a scene was refused"},
    {Exit::kNoServer, "no server, or no answer from it"},
    {Exit::kUnknownId, "no server knows this request"},
    {Exit::kDiffers, "replay: the plan is another"},
    {Exit::kInterrupted, "interrupted"},
};

inline Exit exit_of(msg::State state) {
  switch (state) {
    case msg::SUCCEEDED:
      return Exit::kSucceeded;
    case msg::PARTIAL:
      return Exit::kPartial;
    case msg::FAILED:
      return Exit::kFailed;
    case msg::CANCELLED:
      return Exit::kCancelled;
    case msg::EXPIRED:
      return Exit::kExpired;
    case msg::CRASHED:
      return Exit::kCrashed;
    case msg::REJECTED:
      return Exit::kRejected;
    case msg::UNKNOWN:
      return Exit::kUnknownId;
    case msg::QUEUED:
    case msg::RUNNING:
      break;
  }
  return Exit::kSucceeded;
}

}  // namespace foothold::cli

// The server as one: its end (idl/PROTOCOL.md P23).
#include <spdlog/spdlog.h>

#include "daemon.hpp"
#include "service.hpp"

namespace foothold::server {
namespace {

constexpr double kAcknowledge = 2.0;               // s, for readers to acknowledge
constexpr auto kAtMost = std::chrono::seconds(2);  // beyond the grace time, for requests to end and messages to leave

}  // namespace

void Daemon::stop(int signal) {
  if (stopping_) return;
  stopping_ = true;
  spdlog::info("signal {}: no new work, what runs is cancelled", signal);
  service::stopping();
  if (!jobs_) return leave();
  jobs_->stop();
  stop_timer_.expires_after(std::chrono::duration_cast<Duration>(std::chrono::duration<double>(config_.grace)) + kAtMost);
  stop_timer_.async_wait([this](const boost::system::error_code& error) {
    if (error || leaving_) return;
    spdlog::warn(jobs_->unfinished() ? "not everything ended in time; the rest ends as SERVER_RESTARTED at the next start"
                                     : "clients do not read what waits for them; they can ask for it later");
    leave();
  });
  end_batch();
}

void Daemon::stop_when_idle() {
  if (!leaving_ && jobs_->idle() && partitions_->retry()) leave();
}

void Daemon::leave() {
  leaving_ = true;
  timer_.cancel();
  beat_timer_.cancel();
  retry_timer_.cancel();
  stop_timer_.cancel();
  signals_.cancel();
  hangups_.cancel();
  http_.reset();
  workers_.close([this] {
    inbox_.reset();
    neighbours_.reset();
    if (partitions_ && !partitions_->wait_acknowledged(kAcknowledge)) spdlog::warn("not every client has acknowledged everything");
    partitions_.reset();
    announcer_.reset();
    bus_.reset();
    spdlog::info("stopped");
    loop_.stop();
  });
}

}  // namespace foothold::server

// The server as one: SIGHUP. The files are read and checked apart from the loop, so that work goes on; then all of it is taken, or,
// with one fault anywhere, nothing.
#include <spdlog/spdlog.h>

#include <boost/asio/post.hpp>
#include <memory>
#include <variant>

#include "config/faults.hpp"
#include "daemon.hpp"
#include "log/log.hpp"
#include "service.hpp"

namespace foothold::server {

void Daemon::watch_hangups() {
  hangups_.async_wait([this](const boost::system::error_code& error, int) {
    if (error) return;
    watch_hangups();
    reload();
  });
}

// One at a time: what is asked for meanwhile, or before the server serves, is done once, afterwards.
void Daemon::reload() {
  reload_again_ = reloading_ || !inbox_;
  if (reload_again_ || stopping_) return;
  reloading_ = true;
  spdlog::info("SIGHUP: the configuration is read again");
  service::reloading();
  boost::asio::post(disk_, [this] {
    std::variant<Settings, std::vector<std::string>> read;
    try {
      read = read_again_();
    } catch (const ConfigError& error) {
      read = error.faults();
    } catch (const std::exception& error) {
      read = std::vector<std::string>{error.what()};
    }
    boost::asio::post(loop_, [this, result = std::make_shared<decltype(read)>(std::move(read))] {
      if (stopping_) return;
      if (auto* settings = std::get_if<Settings>(result.get()))
        take_settings(std::move(*settings));
      else
        refuse_settings(std::get<std::vector<std::string>>(*result));
    });
  });
}

void Daemon::refuse_settings(const std::vector<std::string>& faults) {
  ++reloads_refused_;
  for (const std::string& fault : faults) spdlog::error("{}", fault);
  spdlog::error("the configuration has {} fault{} and is not taken; the one of before stays", faults.size(),
                faults.size() == 1 ? "" : "s");
  end_reload();
}

void Daemon::take_settings(Settings settings) {
  ++reloads_;
  ServerConfig& now = settings.server;
  if (now.dds != config_.dds) spdlog::warn("dds is another now: that takes a restart, until then it stays as it was");
  if (now.state_dir != config_.state_dir)
    spdlog::warn("state_dir is another now: that takes a restart, until then it stays as it was");
  now.dds = config_.dds;
  now.state_dir = config_.state_dir;
  const bool metrics_changed = now.metrics != config_.metrics || (now.metrics.enabled && !http_);
  config_ = std::move(now);

  log::set_level(config_.log_level);
  bundles_->set_config(config_.bundles);
  jobs_->set_options(jobs_options());
  scenes_.set_max_bytes(config_.scenes.max_bytes);
  for (const auto& folder : config_.scenes.preload)
    scenes_.preload_again(folder, [](const std::string& complaint) { spdlog::error("scene {}", complaint); });
  if (metrics_changed) open_metrics();
  const auto news = workers_.apply({.program = config_.worker, .limits = config_.workers}, std::move(settings.robots), [this] {
    spdlog::info("the configuration is taken");
    end_reload();
  });
  for (const std::string& sentence : news) spdlog::info("{}", sentence);
  figures_.set_robots(workers_.robots());
  end_batch();
}

void Daemon::end_reload() {
  reloading_ = false;
  if (stopping_) return;
  service::ready(status());
  if (reload_again_) reload();
}

}  // namespace foothold::server

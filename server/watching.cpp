// The server as one: what is to be seen of it over HTTP.
#include <spdlog/spdlog.h>

#include "daemon.hpp"
#include "foothold/msg/errors.hpp"

namespace foothold::server {
namespace {

// However often somebody asks, the loop makes the text no more often than this.
constexpr auto kFresh = std::chrono::milliseconds(100);

const char* name_of(msg::RobotState state) {
  if (state == msg::READY) return "READY";
  return state == msg::QUARANTINED ? "QUARANTINED" : "UNAVAILABLE";
}

std::string topic_name(transport::Topic topic) { return std::string(transport::traits(topic).name); }

}  // namespace

// Planning goes before watching: an address that is taken is told, and the server serves without it.
void Daemon::open_metrics() {
  http_.reset();
  const MetricsConfig& wanted = config_.metrics;
  if (!wanted.enabled) return;
  try {
    http_.emplace(loop_, wanted.address, wanted.port, [this](std::string_view path) { return answer(path); });
    spdlog::info("figures: {}/metrics, health: {}/healthz", http_->url(), http_->url());
    if (!is_loopback(wanted.address))
      spdlog::warn("metrics.address {} is no loopback address: whoever reaches it reads the figures", wanted.address);
  } catch (const HttpError& error) {
    spdlog::error("no figures over HTTP: {}; metrics.port or metrics.address must be another", error.what());
  }
}

void Daemon::open_bundles() {
  bundles_.emplace(
      state_.bundles(), state_.journal(), FOOTHOLD_VERSION + (" " + msg::to_hex(journal_.server_id())), config_.bundles,
      Bundles::Hooks{.background = [this](std::function<void()> work,
                                          std::function<void()> then) { in_background(std::move(work), std::move(then)); },
                     .tell = [](const std::string& place) { spdlog::warn("a bundle to look into: {}", place); },
                     .complain = [](const std::string& sentence) { spdlog::error("{}", sentence); }});
}

HttpAnswer Daemon::answer(std::string_view path) {
  if (path == "/metrics") {
    if (metrics_text_.empty() || clock_.now() - metrics_made_ >= kFresh) {
      metrics_text_ = prometheus_text(look(), figures_);
      metrics_made_ = clock_.now();
    }
    return {.type = "text/plain; version=0.0.4; charset=utf-8", .body = metrics_text_};
  }
  if (path == "/healthz") {
    HealthReport health = health_of(look());
    return {.status = health.well ? 200U : 503U, .body = std::move(health.text)};
  }
  return {.status = 404, .body = "there are /metrics and /healthz\n"};
}

ServerState Daemon::look() const {
  ServerState state;
  state.name = config_.name;
  state.id = msg::to_hex(journal_.server_id());
  state.version = FOOTHOLD_VERSION;
  state.vendor = config_.dds.vendor;
  state.stopping = stopping_;
  state.journal_trouble = journal_.trouble();
  state.queue_limit = config_.queue_limit;
  state.reloads = reloads_;
  state.reloads_refused = reloads_refused_;
  state.credentials_expire = credentials_expire_;
  state.uptime = std::chrono::duration<double>(clock_.now() - started_).count();
  for (const std::string& name : workers_.robots()) {
    const RobotStatus status = workers_.status(name);
    const PoolFigures pool = workers_.figures(name);
    state.robots.push_back({.name = name,
                            .state = name_of(status.info->state()),
                            .reason = status.info->reason(),
                            .slots = status.info->slots(),
                            .busy = pool.busy,
                            .workers = pool.workers,
                            .restarts = pool.restarts,
                            .crashes = pool.crashes,
                            .memory = pool.memory});
  }
  if (!inbox_) return state;  // still loading, or leaving
  state.serving = true;
  if (state.journal_trouble.empty() && !jobs_->storage_works()) state.journal_trouble = "its log cannot be written";
  state.queued = jobs_->load().queued;
  state.running = jobs_->load().running;
  state.partitions = partitions_->size();
  state.left_out = partitions_->left_out();
  state.lost = inbox_->lost();
  state.in_anothers_name = inbox_->in_anothers_name();
  for (const auto& topic : inbox_->figures())
    state.topics.push_back({topic_name(topic.topic), false, topic.matched, topic.unreadable});
  using transport::Topic;
  for (const Topic topic : {Topic::kServer, Topic::kRobot, Topic::kSceneStatus})
    state.topics.push_back({topic_name(topic), true, announcer_->matched(topic), 0});
  const auto [events, steps] = partitions_->matched();
  state.topics.push_back({topic_name(Topic::kEvent), true, events, 0});
  state.topics.push_back({topic_name(Topic::kStep), true, steps, 0});
  return state;
}

}  // namespace foothold::server

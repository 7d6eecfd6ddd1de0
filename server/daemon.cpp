// The server as one: serving.
#include "daemon.hpp"

#include <spdlog/spdlog.h>

#include <boost/asio/post.hpp>
#include <csignal>
#include <thread>

#include "exposure.hpp"
#include "service.hpp"

namespace foothold::server {
namespace {

constexpr auto kBeat = std::chrono::milliseconds(250);
constexpr auto kRetry = std::chrono::milliseconds(2);
constexpr auto kPatience = std::chrono::microseconds(200);
constexpr auto kComplaints = std::chrono::seconds(10);

}  // namespace

Daemon::Daemon(boost::asio::io_context& loop, Settings settings, std::function<Settings()> read_again)
    : loop_(loop),
      config_(std::move(settings.server)),
      started_(clock_.now()),
      state_(config_.state_dir),
      journal_(state_.journal()),
      scenes_({.server = journal_.server_id(), .folder = state_.scenes(), .max_bytes = config_.scenes.max_bytes}, clock_),
      workers_(loop, {.program = config_.worker, .limits = config_.workers}, std::move(settings.robots)),
      read_again_(std::move(read_again)),
      signals_(loop, SIGTERM, SIGINT),
      hangups_(loop, SIGHUP),
      timer_(loop),
      beat_timer_(loop),
      retry_timer_(loop),
      stop_timer_(loop) {
  for (const auto& folder : config_.scenes.preload)
    for (const auto& complaint : scenes_.preload(folder)) spdlog::error("scene {}", complaint);
  signals_.async_wait([this](const boost::system::error_code& error, int signal) {
    if (!error) stop(signal);
  });
  watch_hangups();
  figures_.set_robots(workers_.robots());
  open_metrics();
  open_bundles();
  workers_.open(*this, [this] { open_bus(); });
}

Daemon::~Daemon() { disk_.join(); }

// While a batch waits for a worker's first word, the loop looks again and again instead of sleeping: to be woken takes longer than
// the wait itself.
void Daemon::run() {
  while (!loop_.stopped()) {
    if (!waiting_since_) {
      loop_.run_one();
    } else if (loop_.poll_one() == 0) {
      if (clock_.now() - *waiting_since_ >= kPatience)
        end_batch();
      else
        std::this_thread::yield();
    }
  }
}

// Every robot is ready or refused: from here on the server can be heard.
void Daemon::open_bus() {
  if (stopping_ || bus_) return;
  credentials_expire_ = tell_exposure(config_.dds);
  bus_ = transport::open_bus({.vendor = config_.dds.vendor,
                              .domain = config_.dds.domain,
                              .network_config = config_.dds.network_config,
                              .security = config_.dds.security});
  const auto complain = [this](const std::string& sentence) { spdlog::warn("{}", sentence); };
  announcer_.emplace(*bus_, journal_.server_id());
  partitions_.emplace(*bus_, clock_,
                      Partitions::Hooks{.busy = [this](const Id& client) { return jobs_->busy_for(client); },
                                        .waiting = [this] { retry_soon(); },
                                        .complain = complain});
  jobs_.emplace(jobs_options(),
                Jobs::Ports{journal_,
                            workers_,
                            scenes_,
                            *partitions_,
                            clock_,
                            {&figures_, &request_log_, &*bundles_},
                            [this] { return neighbour_heard_.load(); }},
                [](const std::string& sentence) { spdlog::error("{}", sentence); });
  scenes_.open({.tell = [this](msg::SceneStatus status) { announcer_->scene(std::move(status)); },
                .background = [this](std::function<void()> work,
                                     std::function<void()> then) { in_background(std::move(work), std::move(then)); }});
  listen_to_neighbours();
  jobs_->recover();
  end_batch();
  announce_robots();
  inbox_.emplace(
      loop_, *bus_, [this](ClientMessage message) { take(std::move(message)); }, [this] { batch_soon(); },
      !config_.dds.security.empty());
  beat();
  spdlog::info("server {} ({}) serves: {}", config_.name, msg::to_hex(journal_.server_id()), status());
  service::ready(status());
  if (reload_again_) reload();
}

void Daemon::in_background(std::function<void()> work, std::function<void()> then) {
  boost::asio::post(disk_, [this, work = std::move(work), then = std::move(then)] {
    work();
    boost::asio::post(loop_, then);
  });
}

JobsOptions Daemon::jobs_options() const {
  return {.server = journal_.server_id(),
          .version = FOOTHOLD_VERSION,
          .limits = {.queued = config_.queue_limit,
                     .queued_per_client = config_.admission.queued_per_client,
                     .running_per_client = config_.admission.running_per_client},
          .budget_max = config_.budget_max,
          .grace = config_.grace,
          .cancel_memory = config_.cancel_memory,
          .retention = config_.retention};
}

std::string Daemon::status() const {
  return std::to_string(workers_.robots().size()) + " robots, " + std::string(bus_->vendor()) + " domain " +
         std::to_string(config_.dds.domain);
}

// Whether requests of a time before a restart may have moved to somebody (idl/PROTOCOL.md P36). Who may not listen assumes it.
void Daemon::listen_to_neighbours() {
  const auto on_message = [this, own = journal_.server_id()](std::span<const std::byte> message) {
    const auto info = msg::decode<msg::ServerInfo>(message);
    if (info && info->key() != own) neighbour_heard_ = true;
  };
  try {
    neighbours_ = bus_->reader(transport::Topic::kServer, "", {.on_message = on_message});
  } catch (const transport::BusError& error) {
    neighbour_heard_ = true;
    spdlog::warn("other servers cannot be heard: {}", error.what());
  }
}

void Daemon::take(ClientMessage message) {
  if (auto* request = std::get_if<msg::PlanRequest>(&message))
    jobs_->request(std::move(*request));
  else if (const auto* cancel = std::get_if<msg::CancelRequest>(&message))
    jobs_->cancel(*cancel);
  else if (const auto* query = std::get_if<msg::StateQuery>(&message))
    jobs_->query(*query);
  else
    scenes_.take(std::get<msg::SceneChunk>(message));
}

// The batch ends behind what is ready to be handled now: one commit for all of it. If all of it can wait, it waits for the first
// word of a worker, but not for long.
void Daemon::batch_soon() {
  if (batch_posted_ || !jobs_) return;
  if (jobs_->urgent()) {
    batch_posted_ = true;
    waiting_since_.reset();
    boost::asio::post(loop_, [this] { end_batch(); });
    return;
  }
  if (!waiting_since_) waiting_since_ = clock_.now();
}

void Daemon::end_batch() {
  batch_posted_ = false;
  waiting_since_.reset();
  if (!jobs_) return;
  jobs_->settle();
  if (jobs_->repeating()) retry_soon();
  arm_timer();
  if (stopping_) stop_when_idle();
}

// A timer that fires too early does no harm, and setting it costs a call of the kernel: it is only ever moved forward.
void Daemon::arm_timer() {
  auto next = jobs_->next_deadline();
  if (const auto of_scenes = scenes_.next_deadline(); of_scenes && (!next || *of_scenes < *next)) next = of_scenes;
  if (!next || (armed_ && *armed_ <= *next)) return;
  armed_ = next;
  timer_.expires_at(*next);
  timer_.async_wait([this](const boost::system::error_code& error) {
    if (error) return;
    armed_.reset();
    jobs_->tick();
    scenes_.tick();
    end_batch();
  });
}

void Daemon::retry_soon() {
  if (retrying_) return;
  retrying_ = true;
  retry_timer_.expires_after(kRetry);
  retry_timer_.async_wait([this](const boost::system::error_code& error) {
    if (error) return;
    retrying_ = false;
    const bool through = partitions_->retry();
    jobs_->repeat();
    if (!through || jobs_->repeating()) retry_soon();
    if (stopping_) stop_when_idle();
  });
}

void Daemon::announce_robots() {
  for (const auto& name : workers_.robots()) announcer_->robot(workers_.status(name).info);
}

void Daemon::beat() {
  const Jobs::Load load = jobs_->load();
  msg::ServerInfo info;
  info.name(config_.name);
  info.version(FOOTHOLD_VERSION);
  info.protocol(msg::PROTOCOL_VERSION);
  info.uptime(std::chrono::duration<double>(clock_.now() - started_).count());
  info.queued(static_cast<std::uint32_t>(load.queued));
  info.running(static_cast<std::uint32_t>(load.running));
  std::uint32_t slots = 0;
  for (const auto& name : workers_.robots()) slots += workers_.status(name).info->slots();
  info.slots(slots);
  info.stopping(jobs_->stopping());
  announcer_->beat(std::move(info));
  if (clock_.now() - complained_ >= kComplaints) {
    complained_ = clock_.now();
    partitions_->sweep();
    if (const std::string complaint = inbox_->take_complaint(); !complaint.empty()) spdlog::warn("{}", complaint);
    if (const std::string trouble = journal_.trouble(); !trouble.empty())
      spdlog::error("the log waits for the database: {}", trouble);
  }
  service::alive();
  beat_timer_.expires_after(kBeat);
  beat_timer_.async_wait([this](const boost::system::error_code& error) {
    if (!error) beat();
  });
}

void Daemon::on_run_scene(Run run, std::vector<msg::Shape> shapes) {
  jobs_->on_run_scene(run, std::move(shapes));
  batch_soon();
}

void Daemon::on_run_step(Run run, std::uint32_t index, Bytes step) {
  jobs_->on_run_step(run, index, std::move(step));
  batch_soon();
}

void Daemon::on_run_end(Run run, RunEnd end) {
  jobs_->on_run_end(run, std::move(end));
  batch_soon();
}

void Daemon::on_slots_changed(const std::string& robot) {
  if (!jobs_) return;  // still loading
  announcer_->robot(workers_.status(robot).info);
  jobs_->on_slots_changed(robot);
  batch_soon();
}

}  // namespace foothold::server

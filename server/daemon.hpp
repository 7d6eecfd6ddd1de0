// The server as one: state folder, journal, scenes, workers, requests and bus, on one loop.
//
//   opening  ->  planners load  ->  serving  ->  SIGTERM  ->  requests end  ->  clients acknowledge  ->  workers leave  ->  loop
//   ends
//
// Sources: daemon.cpp (serving), reloading.cpp, watching.cpp, stopping.cpp.
//
// Thread rule: the loop's one thread, for everything; the vendor's threads only post to it (net/inbox.hpp).
#pragma once

#include <utility>  // before Asio, whose 1.74 forgets it under C++20

#include <atomic>
#include <boost/asio/io_context.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/thread_pool.hpp>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "bundles/bundles.hpp"
#include "config/config.hpp"
#include "foothold/transport/bus.hpp"
#include "http/http.hpp"
#include "jobs/jobs.hpp"
#include "journal/journal.hpp"
#include "metrics/server_state.hpp"
#include "net/announcer.hpp"
#include "net/inbox.hpp"
#include "net/partitions.hpp"
#include "request_log.hpp"
#include "scenes/scenes.hpp"
#include "state_folder.hpp"
#include "workers/workers.hpp"

namespace foothold::server {

class Daemon final : private RunEvents {
 public:
  // Opens the state folder and the journal and starts the planners. `read_again`: the settings as they are on disk now, for SIGHUP;
  // called from another thread, throws ConfigError. Throws StateError, JournalError.
  Daemon(boost::asio::io_context& loop, Settings settings, std::function<Settings()> read_again);
  ~Daemon() override;

  // Runs the loop until a signal has ended the server. Throws BusError if the bus cannot be opened, and what a fault of the server
  // itself throws.
  void run();

 private:
  class SystemClock final : public Clock {
   public:
    Time now() const override { return std::chrono::steady_clock::now(); }
    Stamp stamp() const override {
      return std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::system_clock::now().time_since_epoch()).count();
    }
  };

  // serving
  void open_bus();
  void listen_to_neighbours();
  void take(ClientMessage message);
  void batch_soon();
  void end_batch();
  void arm_timer();
  void beat();
  void announce_robots();
  JobsOptions jobs_options() const;
  std::string status() const;
  void retry_soon();

  // reloading
  void watch_hangups();
  void reload();
  void in_background(std::function<void()> work, std::function<void()> then);
  void take_settings(Settings settings);
  void refuse_settings(const std::vector<std::string>& faults);
  void end_reload();

  // watching
  void open_metrics();
  void open_bundles();
  HttpAnswer answer(std::string_view path);
  ServerState look() const;

  // stopping
  void stop(int signal);
  void stop_when_idle();
  void leave();

  void on_run_scene(Run run, std::vector<msg::Shape> shapes) override;
  void on_run_step(Run run, std::uint32_t index, Bytes step) override;
  void on_run_end(Run run, RunEnd end) override;
  void on_slots_changed(const std::string& robot) override;

  boost::asio::io_context& loop_;
  ServerConfig config_;
  SystemClock clock_;
  Time started_;
  StateFolder state_;
  SqliteJournal journal_;
  Scenes scenes_;
  Workers workers_;

  RequestFigures figures_;
  RequestLog request_log_;
  std::optional<Bundles> bundles_;
  std::optional<HttpServer> http_;
  std::string metrics_text_;  // what /metrics said last,
  Time metrics_made_{};       // and when

  std::optional<std::int64_t> credentials_expire_;  // where DDS Security is on
  std::unique_ptr<transport::Bus> bus_;
  std::optional<Announcer> announcer_;
  std::optional<Partitions> partitions_;
  std::optional<Jobs> jobs_;
  std::optional<Inbox> inbox_;
  std::unique_ptr<transport::Reader> neighbours_;
  std::atomic<bool> neighbour_heard_ = false;

  std::function<Settings()> read_again_;
  boost::asio::signal_set signals_, hangups_;
  boost::asio::steady_timer timer_, beat_timer_, retry_timer_, stop_timer_;
  std::optional<Time> armed_;
  bool batch_posted_ = false;
  std::optional<Time> waiting_since_;  // the batch waits for a worker's first word
  bool retrying_ = false;
  bool leaving_ = false;
  bool stopping_ = false;
  bool reloading_ = false, reload_again_ = false;
  std::uint64_t reloads_ = 0, reloads_refused_ = 0;
  Time complained_{};
  boost::asio::thread_pool disk_{1};  // for what waits for the disk: whole scene files
};

}  // namespace foothold::server

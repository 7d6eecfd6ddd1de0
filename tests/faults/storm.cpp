// See storm.hpp.
#include "storm.hpp"

#include <signal.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <iterator>
#include <thread>

namespace foothold::faults {
using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

Storm::Storm(StormOptions options) : options_(std::move(options)), disk_(folder_ / "state") {
  daemon_ = std::make_unique<test::Daemon>(
      test::DaemonOptions{.vendor = options_.server,
                          .domain = options_.domain,
                          .robots = options_.robots,
                          .more = std::string("metrics: {port: 0}\nscenes: {preload: [" FOOTHOLD_CONFIG_DIR "/scenes]}\n") +
                                  "workers: {quarantine_crashes: 100000, restart_longest: 0.2}\n",
                          .plugin_dir = options_.plugin_dir,
                          .state_dir = folder_ / "state"});
  observer_ = std::make_unique<Observer>(options_.server, options_.domain);
  clients_.resize(options_.clients);
}

Storm::~Storm() = default;

void Storm::start_client(std::size_t number) {
  const bool own = number % 2 == 0;
  const std::string vendor = own == (options_.server == "cyclone") ? "cyclone" : "fastdds";
  clients_[number].process = std::make_unique<test::Child>(
      std::vector<std::string>{FOOTHOLD_STORM_CLIENT, vendor, std::to_string(options_.domain), std::to_string(number),
                               std::to_string(options_.requests), std::to_string(options_.at_once), options_.choices,
                               record(number), folder_ / "tally"},
      folder_ / ("client." + std::to_string(number)));
}

std::optional<pid_t> Storm::some_worker() {
  const std::vector<pid_t> workers = daemon_->workers();
  if (workers.empty()) return std::nullopt;
  return workers[random_() % workers.size()];
}

void Storm::strike(Fault fault) {
  switch (fault) {
    case Fault::kServerKilled:
      daemon_->kill();
      std::this_thread::sleep_for(std::chrono::milliseconds(random_() % 300));
      daemon_->start();
      break;
    case Fault::kWorkerKilled:
    case Fault::kWorkerHalted: {
      std::optional<pid_t> worker;
      for (int attempt = 0; !(worker = some_worker()) && attempt < 1000; ++attempt) std::this_thread::sleep_for(10ms);
      if (!worker) return;
      ::kill(*worker, fault == Fault::kWorkerKilled ? SIGKILL : SIGSTOP);
      break;
    }
    case Fault::kClientVanishes: {
      const std::size_t number = random_() % clients_.size();
      if (clients_[number].done) return;
      clients_[number].process->signal(SIGKILL);
      if (clients_[number].process->wait(5.0) == 0) return;  // it had just come to its end
      start_client(number);
      break;
    }
    case Fault::kDiskFull:
      if (!disk_.fill()) return;
      std::this_thread::sleep_for(1500ms);
      disk_.empty();
      // What could not be stored is stored now; a server that is killed before has forgotten it, which the protocol allows (P23).
      std::this_thread::sleep_for(2500ms);
  }
  ++struck_[fault];
}

bool Storm::rage(double seconds) {
  std::vector<Fault> faults;
  for (const auto& [fault, count] : options_.faults)
    if (fault != Fault::kDiskFull || disk_.available()) faults.insert(faults.end(), static_cast<std::size_t>(count), fault);
  std::shuffle(faults.begin(), faults.end(), random_);
  // A full disk lasts: should the load end meanwhile, no other fault shall be left over.
  if (const auto full = std::ranges::find(faults, Fault::kDiskFull); full != faults.end()) std::iter_swap(full, faults.end() - 1);
  for (std::size_t number = 0; number < clients_.size(); ++number) start_client(number);

  const std::size_t requests = std::size_t{options_.clients} * options_.requests;
  const auto until = Clock::now() + std::chrono::duration<double>(seconds);
  std::size_t next = 0;
  for (std::size_t running = clients_.size(); running > 0;) {
    if (Clock::now() > until) return false;
    std::this_thread::sleep_for(20ms);
    // The last fault strikes when three quarters of the load are done.
    if (next < faults.size() && ended() >= (next + 1) * requests * 3 / (4 * (faults.size() + 1))) strike(faults[next++]);
    running = 0;
    for (std::size_t number = 0; number < clients_.size(); ++number) {
      Client& client = clients_[number];
      if (client.done) continue;
      const auto code = client.process->wait(0.0);
      if (code && *code != 0) throw std::runtime_error("client " + std::to_string(number) + " ended with " + std::to_string(*code));
      client.done = code.has_value();
      running += client.done ? 0 : 1;
    }
  }
  return true;
}

std::size_t Storm::ended() const {
  std::size_t lines = 0;
  for (std::size_t number = 0; number < clients_.size(); ++number) {
    std::ifstream in(record(number), std::ios::binary);
    lines += static_cast<std::size_t>(std::count(std::istreambuf_iterator<char>(in), {}, '\n'));
  }
  return lines;
}

std::map<msg::Id, Outcome> Storm::noted() const {
  std::map<msg::Id, Outcome> all;
  for (std::size_t number = 0; number < clients_.size(); ++number) all.merge(read_record(record(number)));
  return all;
}

std::map<std::uint64_t, int> Storm::tally() const {
  std::map<std::uint64_t, int> out;
  std::ifstream in(folder_ / "tally");
  for (std::uint64_t seed = 0; in >> seed;) ++out[seed];
  return out;
}

std::string Storm::journal() const { return folder_ / "state/journal.db"; }

std::string Storm::scenes() const { return folder_ / "state/scenes"; }

std::string Storm::missing() const {
  std::string out;
  for (std::size_t number = 0; number < clients_.size(); ++number)
    out += "client " + std::to_string(number) + ": " + std::to_string(read_record(record(number)).size()) + " of " +
           std::to_string(options_.requests) + (clients_[number].done ? ", ended\n" : "\n");
  return out;
}

}  // namespace foothold::faults

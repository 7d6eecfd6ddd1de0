// A server under load, and everything that may go wrong with it, in one place: the storm.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "child.hpp"
#include "daemon.hpp"
#include "observer.hpp"
#include "record.hpp"
#include "small_disk.hpp"

namespace foothold::faults {

enum class Fault { kServerKilled, kWorkerKilled, kWorkerHalted, kClientVanishes, kDiskFull };
inline constexpr const char* kFaultNames[] = {"server killed", "worker killed", "worker halted", "client vanishes", "disk full"};

struct StormOptions {
  std::string server = "cyclone";  // vendor
  std::uint32_t domain = 41;
  std::uint32_t clients = 4;   // every second one of the other vendor
  std::uint32_t requests = 0;  // of each client
  std::uint32_t at_once = 4;   // of each client
  std::map<Fault, int> faults;
  std::string choices;     // file of read_choices()
  std::string plugin_dir;  // shipped and bad planners
  std::vector<test::TestRobot> robots;
};

// Thread rule: the main thread.
class Storm {
 public:
  explicit Storm(StormOptions options);
  ~Storm();

  // Lets the clients loose, strikes with every fault, spread over the load, and waits for the clients' ends. False if they do not
  // come within `seconds`; what is missing is then in missing().
  bool rage(double seconds);
  // Stops the server; its exit code.
  std::optional<int> stop() { return daemon_->stop(20.0); }

  std::map<msg::Id, Outcome> noted() const;    // of all clients
  std::map<std::uint64_t, int> tally() const;  // how often the planner `tally` was asked, by seed
  const Observer& observer() const { return *observer_; }
  std::string journal() const;
  std::string scenes() const;  // folder of the stored ones
  std::string log() const { return daemon_->log(); }
  const std::map<Fault, int>& struck() const { return struck_; }
  bool disk_can_fill() const { return disk_.available(); }
  std::string missing() const;

 private:
  struct Client {
    std::unique_ptr<test::Child> process;
    bool done = false;
  };
  std::string record(std::size_t client) const { return folder_ / ("record." + std::to_string(client)); }
  std::size_t ended() const;  // requests, as the clients noted
  void start_client(std::size_t number);
  void strike(Fault fault);
  std::optional<pid_t> some_worker();

  StormOptions options_;
  test::TemporaryFolder folder_;
  SmallDisk disk_;
  std::unique_ptr<test::Daemon> daemon_;
  std::unique_ptr<Observer> observer_;
  std::vector<Client> clients_;
  std::map<Fault, int> struck_;
  std::mt19937_64 random_{7};
};

}  // namespace foothold::faults

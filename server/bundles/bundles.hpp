// What a crashed or slow plan leaves behind for who looks into it: a folder `<state folder>/bundles/<kind>/<time>-<id>` with
//
//   report.txt      for people: what happened, versions, scene's hash, signal, backtrace, the latest lines of the log
//   plan.entries    for `foothold replay FOLDER`: request, steps and end as entries of the journal
//
// kind: crashed (its worker crashed, ran out of memory, or had to be killed) or slow (it took longer than configured). Of each kind
// only the newest are kept. Made apart from the loop; how many wait for that is bounded, and what finds no place is told.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "config/config.hpp"
#include "jobs/watch.hpp"

namespace foothold::server {

// Thread rule: the loop; `background` runs its first function anywhere else, the second on the loop.
class Bundles final : public RequestWatch {
 public:
  static constexpr std::size_t kMostWaiting = 8;

  struct Hooks {
    std::function<void(std::function<void()>, std::function<void()>)> background;
    std::function<void(const std::string&)> tell;      // where a bundle is, for the log
    std::function<void(const std::string&)> complain;  // why one is not
  };

  // `folder`: of all bundles; `journal`: the database's path; `server`: version and id, for the report.
  Bundles(std::string folder, std::string journal, std::string server, BundlesConfig config, Hooks hooks);

  void set_config(const BundlesConfig& config) { config_ = config; }
  void on_step(const msg::PlanRequest&, std::uint32_t, double, double) override {}
  void on_ended(const EndedRequest& ended) override;

 private:
  std::string folder_, journal_, server_;
  BundlesConfig config_;
  Hooks hooks_;
  std::size_t waiting_ = 0, left_out_ = 0;
  std::shared_ptr<bool> alive_ = std::make_shared<bool>(true);
};

}  // namespace foothold::server

// What became of requests, counted by robot: final states, and how long waiting, planning and each step took.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "jobs/watch.hpp"
#include "metrics/exposition.hpp"

namespace foothold::server {

// Thread rule: the loop.
class RequestFigures final : public RequestWatch {
 public:
  // Only these names become labels, all others count under "": what a client calls its robot must not make figures grow.
  void set_robots(const std::vector<std::string>& names);

  void on_step(const msg::PlanRequest& request, std::uint32_t index, double since_last, double since_receipt) override;
  void on_ended(const EndedRequest& ended) override;

  void write(Exposition& out) const;

 private:
  struct Robot {
    std::map<std::string, std::uint64_t, std::less<>> ended;  // by state's name
    std::uint64_t steps = 0;
    Histogram wait, plan, step, first_step;
  };
  Robot& of(const std::string& robot);

  std::map<std::string, Robot> robots_;
};

}  // namespace foothold::server

// One line of the log for each request that ended.
#pragma once

#include "jobs/watch.hpp"

namespace foothold::server {

// Thread rule: the loop.
class RequestLog final : public RequestWatch {
 public:
  void on_step(const msg::PlanRequest&, std::uint32_t, double, double) override {}
  void on_ended(const EndedRequest& ended) override;
};

}  // namespace foothold::server

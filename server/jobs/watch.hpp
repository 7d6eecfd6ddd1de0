// What is to be seen of requests from outside the state machine: for figures, the log and bundles.
#pragma once

#include <cstdint>

#include "jobs/ports.hpp"

namespace foothold::server {

// How a request ended. The references live for the call. Times in seconds.
struct EndedRequest {
  const msg::PlanRequest& request;  // of a rejected one: its essence
  const msg::PlanEvent& event;      // the final one
  bool ran = false;                 // it was given to a worker by this process
  double waited = 0.0;              // from receipt to its start, or to its end if it never started
  double planned = 0.0;             // from its start to its end
  bool killed = false;              // its worker was killed for not heeding the stop token
};

// Thread rule: the loop. Called from inside Jobs: note and return.
class RequestWatch {
 public:
  virtual ~RequestWatch() = default;
  // A new step, not one that a restart repeats. `since_last`: s since the step before it, or since the start of the run;
  // `since_receipt`: s since the request came.
  virtual void on_step(const msg::PlanRequest& request, std::uint32_t index, double since_last, double since_receipt) = 0;
  // Once for each request, when its end was committed and told, or could not be stored and was told.
  virtual void on_ended(const EndedRequest& ended) = 0;
};

}  // namespace foothold::server

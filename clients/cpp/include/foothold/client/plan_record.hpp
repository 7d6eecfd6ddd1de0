// A plan as a whole: what was asked, how it ended, the scene and every step. Plain values: what a file holds and a drawing shows.
#pragma once

#include <foothold.h>

#include <vector>

namespace foothold::client {

struct PlanRecord {
  msg::PlanRequest request;       // of a plan asked for by its id alone: only the id is known
  msg::PlanEvent final_event;     // state UNKNOWN while the plan has not ended
  std::vector<msg::Shape> scene;  // if the request asked for shapes
  std::vector<msg::Step> steps;   // in order, from 0
};

}  // namespace foothold::client

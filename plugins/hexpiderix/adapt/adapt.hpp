// From a situation to the posture that a method gives it: one interface to the paper's strategies and the best posture.
#pragma once

#include <stop_token>
#include <string>

#include "foothold/planner.hpp"
#include "hexpiderix/optimal/best_posture.hpp"
#include "hexpiderix/strategies/strategies.hpp"

namespace foothold::hexpiderix {

enum class Method { kOptimal, kChoice, kConstant, kGeometric, kEmergency };
enum class FurtherLegs { kKeep, kAdd, kAny };

struct AdaptOptions {
  Method method = Method::kOptimal;
  FurtherLegs legs = FurtherLegs::kKeep;
  double share = 0.5;
  BestOptions best;
};

struct Adaption {
  enum class End { kFound, kRefused, kUnstable, kNoneStable, kExhausted, kStopped };
  End end = End::kRefused;
  Footholds footholds;    // legs that joined included
  Evaluation evaluation;  // of the posture; valid if kFound or kUnstable
  std::string about;      // what was done, for people
  std::string because;    // why not, unless kFound
  double on_grid = 0.0;   // m, optimal: NESM of the grid's best, proved greatest of its poses and sets of legs
  bool proved = false;
  long boxes = 0, evaluated = 0;
};

// Any thread.
Adaption adapt(const Model& model, const Situation& from, const AdaptOptions& options, const std::stop_token& stop);

}  // namespace foothold::hexpiderix

// Methods of adaption, told alike.
#include "hexpiderix/adapt/adapt.hpp"

#include <cmath>
#include <cstdio>
#include <vector>

namespace foothold::hexpiderix {
namespace {

std::string names(Legs legs) {
  std::string out;
  for (std::size_t leg = 0; leg < kLegs; ++leg)
    if (legs[leg]) out += (out.empty() ? "" : ", ") + std::to_string(leg + 1);
  return out;
}

std::string millimetres(double metres) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f mm", 1e3 * metres);
  return text;
}

// Legs that may stand: those that do, with any of the others, and the other triad.
std::vector<Legs> sets_of_legs(Legs supports, FurtherLegs further) {
  std::vector<Legs> out{supports};
  if (further == FurtherLegs::kKeep) return out;
  for (unsigned long bits = 1; bits < (1UL << kLegs); ++bits) {
    const Legs set(bits);
    const bool joined = (set & supports) == supports && set != supports;
    if (joined || (further == FurtherLegs::kAny && set != supports && (set == kTriad1 || set == kTriad2))) out.push_back(set);
  }
  return out;
}

// The situation on a set of legs, once for each choice of places for those that join.
std::vector<Situation> standing_on(const Situation& from, Legs legs) {
  const Legs joining = legs & ~from.footholds.supports;
  Situation with = from;
  with.footholds.supports = legs;
  if (joining.none() || from.places.empty()) return {with};
  std::vector<Situation> out;
  for (const Footholds& place : from.places) {
    if ((joining & ~place.supports).any()) continue;
    for (std::size_t leg = 0; leg < kLegs; ++leg) {
      if (!joining[leg]) continue;
      with.footholds.points[leg] = place.points[leg];
      with.footholds.normals[leg] = place.normals[leg];
    }
    out.push_back(with);
  }
  return out;
}

std::vector<Situation> situations(const Situation& from, FurtherLegs further) {
  std::vector<Situation> out;
  for (const Legs legs : sets_of_legs(from.footholds.supports, further))
    for (Situation& with : standing_on(from, legs)) out.push_back(std::move(with));
  return out;
}

Adaption from_strategy(const Model& model, const Situation& from, const AdaptOptions& options) {
  Adapted found;
  switch (options.method) {
    case Method::kConstant:
      found = constant_orientation(model, from);
      break;
    case Method::kGeometric:
      found = geometric(model, from, options.share);
      break;
    case Method::kEmergency:
      found = emergency(model, from, EmergencyRule::kLongestDistance);
      break;
    case Method::kChoice:
    case Method::kOptimal:
      found = chosen(model, from);
      break;
  }
  Adaption out{Adaption::End::kFound, found.footholds, found.evaluation, std::string(name(found.strategy)) + ": " + found.about,
               ""};
  if (!found.evaluation.valid()) {
    out.end = Adaption::End::kRefused;
    out.because = out.about + ": " + reason(found.evaluation);
  } else if (!found.stable()) {
    out.end = Adaption::End::kUnstable;
    out.because = out.about + ": NESM " + millimetres(found.evaluation.nesm) + ", it tips";
  } else if (std::isfinite(options.best.friction) &&
             friction_needed(found.footholds, found.evaluation.centre_of_mass) > options.best.friction) {
    out.end = Adaption::End::kUnstable;
    out.because = out.about + ": it slides";
  }
  return out;
}

Adaption best_of(const Model& model, const Situation& from, const AdaptOptions& options, const std::stop_token& stop) {
  Adaption out;
  out.end = Adaption::End::kNoneStable;
  out.evaluation = {};
  out.on_grid = -std::numeric_limits<double>::infinity();
  out.proved = true;
  const std::vector<Situation> choices = situations(from, options.legs);
  for (const Situation& with : choices) {
    const BestPosture best = best_posture(model, with, options.best, stop);
    out.boxes += best.boxes;
    out.evaluated += best.evaluated;
    out.on_grid = std::max(out.on_grid, best.on_grid.nesm);
    if (best.end == BestPosture::End::kStopped) {
      out.end = Adaption::End::kStopped;
      return out;
    }
    out.proved = out.proved && best.end != BestPosture::End::kExhausted;
    if (!best.polished.valid() || best.polished.nesm <= std::max(0.0, out.evaluation.nesm)) continue;
    out.end = Adaption::End::kFound;
    out.footholds = with.footholds;
    out.evaluation = best.polished;
    out.about = "greatest stability on legs " + names(with.footholds.supports);
  }
  if (out.end == Adaption::End::kFound) return out;
  if (!out.proved) out.end = Adaption::End::kExhausted;
  // The grid holds no stable posture; between its poses there may be one, or a proof that there is none.
  long proved_none = 0, asked = 0;
  for (const Situation& with : choices) {
    BestOptions bounded = options.best;
    bounded.most_boxes = std::min(bounded.most_boxes, 300'000L);
    const Existence exists = stable_posture(model, with, bounded, stop);
    ++asked;
    out.boxes += exists.boxes;
    proved_none += exists.answer == Existence::Answer::kProvedNone;
    if (exists.answer != Existence::Answer::kFound) continue;
    out.end = Adaption::End::kFound;
    out.footholds = with.footholds;
    out.evaluation = exists.found;
    out.proved = false;
    out.about = "a stable posture between the grid's, on legs " + names(with.footholds.supports);
    return out;
  }
  if (stop.stop_requested()) out.end = Adaption::End::kStopped;
  out.because = proved_none == asked ? "proved: no posture on these footholds is stable"
                                     : "no posture of the grid is stable, and none between was found";
  return out;
}

}  // namespace

Adaption adapt(const Model& model, const Situation& from, const AdaptOptions& options, const std::stop_token& stop) {
  return options.method == Method::kOptimal ? best_of(model, from, options, stop) : from_strategy(model, from, options);
}

}  // namespace foothold::hexpiderix

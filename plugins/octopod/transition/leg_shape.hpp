// A leg on its standing branch by the place of its foot alone, without angles: where the knee is, how fast it can move, and where
// the branch is smooth. What moves between postures is bounded with it. Values; any thread.
#pragma once

#include <cmath>

#include "octopod/model/model.hpp"

namespace foothold::octopod {

// A foot seen from its shoulder, m: out to the leg's side, forth along the module's X, up.
struct FromShoulder {
  double out = 0.0, forth = 0.0, up = 0.0;
  double distance() const { return std::sqrt(out * out + forth * forth + up * up); }
  // In the leg's plane, from the femur's joint: along the plane (negative: back under the body).
  double along(const Model& model) const { return std::copysign(std::sqrt(out * out + forth * forth), out) - model.coxa; }
  double from_hip(const Model& model) const {
    const double x = along(model);
    return std::sqrt(x * x + up * up);
  }
};

inline FromShoulder between(const FromShoulder& a, const FromShoulder& b, double part) {
  return {a.out + part * (b.out - a.out), a.forth + part * (b.forth - a.forth), a.up + part * (b.up - a.up)};
}
inline double apart(const FromShoulder& a, const FromShoulder& b) {
  return FromShoulder{a.out - b.out, a.forth - b.forth, a.up - b.up}.distance();
}

// Feet stay where the leg neither stretches nor folds nor swings through under its shoulder: there its joints would jump.
inline constexpr double kStretch = 0.9975;  // of femur and tibia; standing legs keep to 0.995 of the reach
inline constexpr double kFold = 0.15;       // likewise
inline constexpr double kInside = 0.005;    // m, of |out|

// Whether it may be there, if it began on side `sign` (+1: outside, -1: beneath the body) and everything may be off by `slack` (m).
inline bool may_be(const Model& model, const FromShoulder& foot, double sign, double slack = 0.0) {
  const double length = model.femur + model.tibia, distance = foot.from_hip(model);
  return distance + slack <= kStretch * length && distance - slack >= kFold * length && sign * foot.out - slack >= kInside;
}
// The same all along the straight way between two places: the greatest distance is at an end, the least one is bounded by its
// middle.
inline bool may_be_between(const Model& model, const FromShoulder& a, const FromShoulder& b, double sign, double slack) {
  return may_be(model, a, sign, slack) && may_be(model, b, sign, slack) &&
         between(a, b, 0.5).from_hip(model) - 0.5 * apart(a, b) - slack >= 0.5 * kFold * (model.femur + model.tibia);
}

// The knee seen from the shoulder (out, forth, up). Precondition: may_be.
inline FromShoulder knee(const Model& model, const FromShoulder& foot) {
  const double level = std::copysign(std::sqrt(foot.out * foot.out + foot.forth * foot.forth), foot.out);
  const double x = foot.along(model), squared = x * x + foot.up * foot.up, distance = std::sqrt(squared);
  const double along = (squared + model.femur * model.femur - model.tibia * model.tibia) / (2 * distance);
  const double across = std::sqrt(std::max(0.0, model.femur * model.femur - along * along));
  // To the left of the line from hip to foot: up where the leg hangs outwards.
  const double in_plane = model.coxa + (along * x - across * foot.up) / distance;
  return {in_plane * foot.out / level, in_plane * foot.forth / level, (along * foot.up + across * x) / distance};
}

// How many metres the knee moves at most for one metre of the foot (both seen from the shoulder), on a straight way that may_be.
inline double knee_rate(const Model& model, const FromShoulder& a, const FromShoulder& b) {
  const double f = model.femur, t = model.tibia, way = apart(a, b);
  const double high = std::min(std::max(a.from_hip(model), b.from_hip(model)), kStretch * (f + t));
  const double low = std::max(between(a, b, 0.5).from_hip(model) - 0.5 * way, 0.5 * kFold * (f + t));
  const auto bending = [&](double d) {
    const double cosine = (d * d + f * f - t * t) / (2 * f * d);
    return std::abs(1 - (f * f - t * t) / (d * d)) / (2 * std::sqrt(std::max(1e-6, 1 - cosine * cosine)));
  };
  const double aside = std::max(std::min(std::abs(a.out), std::abs(b.out)), kInside);
  return f / low + std::max(bending(low), bending(high)) + (f + model.coxa) / aside;
}

}  // namespace foothold::octopod

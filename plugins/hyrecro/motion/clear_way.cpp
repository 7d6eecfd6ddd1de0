#include "hyrecro/motion/clear_way.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "hyrecro/motion/sweep.hpp"

namespace foothold::hyrecro {
namespace {

// A way is given up where more postures than this would have to be judged for each of its pieces, or parts shorter than this: it
// all but touches.
constexpr std::size_t kMostJudged = 3000;
constexpr double kShortest = 1e-5;
// Distances are exact up to rounding only.
constexpr double kRounding = 1e-9;

// The part of half the way that distances prove, at most 1, and which pair is the narrowest.
struct Proof {
  double part = 1.0;
  const char* what = "";
  // `room`: distance less what has to be kept. False: not even this posture is free.
  bool narrow(double room, double moved, const char* pair) {
    room -= kRounding;
    const bool known = std::isfinite(moved);
    if (known && room >= moved) return true;
    const double here = known && room > 0.0 ? room / moved : 0.0;
    if (here < part || room <= 0.0) {
      part = here;
      what = pair;
    }
    return room > 0.0;
  }
};

// Distance, or a lower bound of it (by the spheres around both) if that is at least `enough`.
template <typename A, typename B>
double distance_up_to(const A& a, const Vector3d& at_a, double radius_a, const B& b, const Vector3d& at_b, double radius_b,
                      double enough) {
  const double under = (at_a - at_b).norm() - radius_a - radius_b;
  return under >= enough ? under : collision::distance(a, b);
}

// False as soon as the posture itself is not free.
bool prove(const Surroundings& around, const Coordinates& coordinates, const Sweep& moved, Proof& proof) {
  const Bodies bodies = bodies_at(around.model, coordinates, around.holding);
  ++around.judged;
  const double kept = around.clearance;
  const auto enough = [](double keep, double move) { return keep + (std::isfinite(move) ? move : 0.0) + 2.0 * kRounding; };
  const auto in_scene = [&](const auto& body, double keep, double move, const char* pair) {
    return proof.narrow(around.obstacles.distance(body, enough(keep, move)) - keep, move, pair);
  };
  const auto leg_plate = [&](std::size_t l, std::size_t p, double move, const char* pair) {
    const collision::Capsule& capsule = bodies.leg[l];
    const double radius = 0.5 * (capsule.b - capsule.a).norm() + capsule.radius;
    return proof.narrow(distance_up_to(capsule, 0.5 * (capsule.a + capsule.b), radius, bodies.plate[p],
                                       bodies.plate[p].pose.translation(), bodies.plate[p].half.norm(), enough(kept, move)) -
                            kept,
                        move, pair);
  };
  const auto boxes = [&](const collision::Box& a, const collision::Box& b, double move, const char* pair) {
    return proof.narrow(
        distance_up_to(a, a.pose.translation(), a.half.norm(), b, b.pose.translation(), b.half.norm(), enough(kept, move)) - kept,
        move, pair);
  };
  return proof.narrow(collision::distance(bodies.leg[0], bodies.leg[1]) - kept, moved.legs, "the legs meet") &&
         in_scene(bodies.plate[1], 0.0, moved.plate1, "the free plate meets a solid") &&
         in_scene(bodies.leg[1], kept, moved.leg1, "the free leg meets a solid") &&
         in_scene(bodies.leg[0], kept, moved.leg0, "the leg that holds meets a solid") &&
         in_scene(bodies.hip, kept, moved.hip, "the hip meets a solid") &&
         leg_plate(0, 1, moved.leg0 + moved.plate1, "the leg that holds meets the free plate") &&
         leg_plate(1, 0, moved.leg1, "the free leg meets the plate that holds") &&
         boxes(bodies.plate[0], bodies.plate[1], moved.plate1, "the plates meet") &&
         boxes(bodies.plate[0], bodies.hip, moved.hip, "the plate that holds meets the hip") &&
         boxes(bodies.plate[1], bodies.hip, moved.plate1_about_hip, "the free plate meets the hip");
}

}  // namespace

Blocked judge_posture(const Surroundings& around, const Coordinates& coordinates) {
  Proof proof;
  if (prove(around, coordinates, Sweep{}, proof)) return {};
  return {proof.what};
}

Blocked judge_way(const Surroundings& around, std::span<const Actuators> way) {
  if (around.stop.stop_requested()) return {"stopped"};
  struct Part {
    std::size_t piece;
    double begin, end;
  };
  std::vector<Part> parts;
  for (std::size_t piece = 0; piece + 1 < way.size(); ++piece) parts.push_back({piece, 0.0, 1.0});
  for (std::size_t next = 0; next < parts.size(); ++next) {
    const Part part = parts[next];
    const double middle = 0.5 * (part.begin + part.end), half = 0.5 * (part.end - part.begin);
    const Actuators &a = way[part.piece], way_on = way[part.piece + 1] - a;
    const Coordinates coordinates = from_actuators(around.model, a + middle * way_on);
    const Sweep moved = sweep(around.model, a + part.begin * way_on, a + part.end * way_on, coordinates);
    Proof proof;
    if (!prove(around, coordinates, moved, proof)) return {proof.what};
    if (proof.part >= 1.0) continue;
    if (half < kShortest || next > kMostJudged * way.size())
      return {std::string("so near that it cannot be proved free: ") + proof.what};
    const double proved = half * proof.part;
    parts.push_back({part.piece, part.begin, middle - proved});
    parts.push_back({part.piece, middle + proved, part.end});
  }
  return {};
}

Blocked judge_way(const Surroundings& around, const Actuators& a, const Actuators& b) {
  return judge_way(around, std::array{a, b});
}

}  // namespace foothold::hyrecro

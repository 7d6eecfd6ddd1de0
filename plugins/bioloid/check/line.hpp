// The proof of one straight line in the joints, from one point of the motion to the next.
#pragma once

#include <optional>
#include <vector>

#include "bioloid/check/check.hpp"
#include "bioloid/check/skeleton.hpp"
#include "bioloid/check/surroundings.hpp"

namespace foothold::bioloid::check {

// The least seen so far.
struct Seen {
  double clearance = 0.1;                                         // m, as far as is looked
  double balance = HUGE_VAL, ground = HUGE_VAL, slip = HUGE_VAL;  // m; ground: lowest corner of the sole in the air
  double lift = 0.0;                                              // m, greatest height of the lowest corner
};

// The hull of the soles that stand, seen from the one that stands all along.
class Support {
 public:
  Support(const Model& model, const std::optional<Isometry3d>& second);
  // m, signed: positive inside. Concave: along a straight line it is least at an end.
  double margin(const Vector3d& centre_of_mass) const;

 private:
  std::vector<std::pair<Eigen::Vector2d, double>> edges_;  // inward normals and offsets
};

struct Judged {
  const Model& model;
  const CheckOptions& options;
  const Skeleton& skeleton;
  const Surroundings& surroundings;
  Side moving;  // the other foot
};

// Lowest corner of the other sole, m over the ground.
double lowest_corner(const Judged& judged, const Instant& instant);
// Pose of the other sole, seen from the one that stands.
Isometry3d other_sole(const Judged& judged, const Instant& instant);
struct Line {
  Joints from, change;
  double begin = 0.0, end = 0.0;     // s
  std::optional<Isometry3d> stands;  // where the other sole stands; none: it is in the air
  Rates rates;
  std::vector<double> slopes;  // m, by which each of the surroundings' items can change along the line
};
Line line_between(const Judged& judged, const Joints& from, const Joints& to);

// Lower bounds of the distances of all items at the motion's points, one point after the other: what is far stays far for a while.
class Distances {
 public:
  explicit Distances(const Judged& judged);
  // At the next point; `before` and `after`: the lines that meet there, null at the ends. Throws judge::Refusal for what is too
  // near.
  void next(const Instant& instant, double time, const Line* before, const Line* after, Seen& seen);
  // Items whose distances at both ends of the line before do not show that they keep clear all along it.
  const std::vector<std::size_t>& open() const { return open_; }

 private:
  const Judged& judged_;
  std::vector<double> bounds_;
  std::vector<std::size_t> open_;
};

// `open`: items that are still to be shown clear. Throws judge::Refusal with the instant at which something is wrong.
void prove(const Judged& judged, const Line& line, const Support& support, const std::vector<std::size_t>& open, Seen& seen);

}  // namespace foothold::bioloid::check

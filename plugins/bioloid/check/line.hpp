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

// Lowest corner of the other foot, m over the ground.
double lowest_corner(const Judged& judged, const Instant& instant);
// Pose of the other sole, seen from the one that stands.
Isometry3d other_sole(const Judged& judged, const Instant& instant);
// Notes clearances at one instant; throws judge::Refusal for none.
void look(const Judged& judged, const Instant& instant, const Support& support, double time, Seen& seen);

struct Line {
  Joints from, to;
  double begin = 0.0, end = 0.0;     // s
  std::optional<Isometry3d> stands;  // where the other sole stands; none: it is in the air
};
// Throws judge::Refusal with the instant at which something is wrong.
void prove(const Judged& judged, const Line& line, const Support& support, Seen& seen);

}  // namespace foothold::bioloid::check

// Feet on the ground.
#include <algorithm>
#include <cmath>
#include <vector>

#include "octopod/check/setting.hpp"

namespace foothold::octopod {
namespace {

constexpr double kNormalTolerance = 1e-6;  // rad, nearly: difference of unit vectors
constexpr double kHollow = 1e-9;           // m, by which a triangle must rise above another's plane to make the ground hollow

// The ground's least distance, and whether some triangle that near has the contact's normal.
void judge_on_ground(const Setting& setting, const Contact& contact, const std::string& where) {
  const Vector3d at = contact.frame.translation(), normal = contact.frame.linear().col(2);
  double least = 1.0, off = 2.0;
  for (const Triangle& t : setting.triangles) {
    if (!t.ground) continue;
    const double away = distance(at, t);
    least = std::min(least, away);
    if (away <= kTouch) off = std::min(off, (normal - t.normal).norm());
  }
  if (!(least <= kTouch)) refuse(where, ": foot ", contact.limb, " stands ", least, " m from the ground (1 m: or more)");
  if (!(off <= kNormalTolerance))
    refuse(where, ": the normal of foot ", contact.limb, "'s contact is ", off, " rad off the ground's");
}

}  // namespace

Feet judge_feet(const Setting& setting, std::span<const Contact> stance, const std::string& where) {
  if (stance.size() != kLegs) refuse(where, ": ", stance.size(), " feet stand, not ", kLegs);
  Feet out;
  for (int k = 0; k < kLegs; ++k) {
    const auto found = std::find_if(stance.begin(), stance.end(), [&](const Contact& c) { return c.limb == limb(k); });
    if (found == stance.end()) refuse(where, ": foot ", limb(k), " does not stand");
    judge_on_ground(setting, *found, where);
    out[static_cast<std::size_t>(k)] = {found->frame.translation(), found->frame.linear().col(2)};
  }
  return out;
}

double judge_closure(const Skeleton& at, const Feet& feet, const std::string& where) {
  double most = 0.0;
  for (std::size_t k = 0; k < kLegs; ++k) {
    const double error = (at.limbs[k].foot - feet[k].point).norm();
    if (!(error <= judge::kPoseTolerance))
      refuse(where, ": the joints put foot ", limb(static_cast<int>(k)), " ", error, " m beside its contact");
    most = std::max(most, error);
  }
  return most;
}

Seat seat_of(const Setting& setting, const Vector3d& sole) {
  Seat out;
  out.sole = sole;
  const double around = 2.0 * setting.model.foot + kTouch;
  for (const Triangle& t : setting.triangles) {
    if (t.bounds.exteriorDistance(sole) > around) continue;
    const double away = distance(sole, t);
    if (away <= around) (away <= kTouch ? out.under : out.beside).push_back(&t);
  }
  for (const Triangle* t : out.under)
    for (const Triangle* other : out.under)
      for (const Vector3d& corner : other->corners) out.hollow = out.hollow || t->normal.dot(corner - t->corners[0]) > kHollow;
  return out;
}

double rise(const Seat& seat, const Vector3d& ankle) {
  double least = HUGE_VAL, most = -HUGE_VAL;
  for (const Triangle* t : seat.under) {
    const double height = t->normal.dot(ankle - seat.sole);
    least = std::min(least, height);
    most = std::max(most, height);
  }
  return seat.hollow ? least : most;
}

double standing_distance(const Seat& seat, const Vector3d& sole, const Vector3d& ankle, double reach) {
  const Vector3d from = sole + kSoleLength * (ankle - sole).normalized();
  double least = reach;
  for (const Triangle* t : seat.beside) least = std::min(least, distance(from, ankle, *t));
  return least;
}

double flying_distance(const Setting& setting, const Vector3d& sole, const Vector3d& ankle, double reach) {
  Eigen::AlignedBox3d bounds(sole);
  bounds.extend(ankle);
  double least = reach;
  for (const Triangle& t : setting.triangles)
    if (bounds.exteriorDistance(t.bounds) < least) least = std::min(least, distance(sole, ankle, t));
  return least;
}

}  // namespace foothold::octopod

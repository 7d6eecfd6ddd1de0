// Contacts before, placed and after, held against each other.
#include "bioloid/check/feet.hpp"

#include <array>
#include <cmath>

#include "judge/refusal.hpp"

namespace foothold::bioloid::check {
namespace {

using judge::refuse;

Side side_of(const Contact& contact, const char* where) {
  for (const Side side : {Side::kRight, Side::kLeft})
    if (contact.limb == name_at(kLimbs, index_of(side))) return side;
  refuse(where, " names the limb '", contact.limb, "'; the robot's are right_foot and left_foot");
}

std::array<const Contact*, 2> by_side(const std::vector<Contact>& contacts, const char* where) {
  std::array<const Contact*, 2> out{};
  for (const Contact& contact : contacts) {
    const Contact*& at = out[index_of(side_of(contact, where))];
    if (at) refuse(where, " names ", contact.limb, " twice");
    at = &contact;
    const Isometry3d& frame = contact.frame;
    const double tilt = std::hypot(frame.linear()(0, 2), frame.linear()(1, 2));
    if (!(std::abs(frame.translation().z()) <= judge::kPoseTolerance && tilt <= judge::kPoseTolerance &&
          frame.linear()(2, 2) > 0.0))
      refuse(where, ": ", contact.limb, " is not on the ground: ", frame.translation().z(), " m high, tilted by ",
             std::atan2(tilt, frame.linear()(2, 2)), " rad");
  }
  return out;
}

bool same(const Contact* a, const Contact* b) { return a && b && judge::error_between(a->frame, b->frame) <= judge::kSame; }

}  // namespace

Feet feet_of(const Step& step, const Posture& before) {
  const auto old = by_side(before.stance, "the posture before"), placed = by_side(step.placed, "the step"),
             now = by_side(step.after.stance, "the posture after");
  if (step.placed.size() > 1) refuse("a step places one foot, this one places both");
  std::optional<Side> standing;
  for (const Side side : {Side::kRight, Side::kLeft}) {
    const std::size_t i = index_of(side);
    const std::string name = name_at(kLimbs, i);
    if (placed[i]) {
      if (!same(placed[i], now[i])) refuse(name, " is placed where the posture after does not have it");
      continue;
    }
    if (now[i] && !old[i]) refuse(name, " stands after the step, but neither stood before nor is placed");
    if (!now[i] || !old[i]) continue;
    if (!same(old[i], now[i]))
      refuse(name, " is not placed, but stands ", judge::apart(old[i]->frame, now[i]->frame), " m and ",
             judge::turned(old[i]->frame, now[i]->frame), " rad from where it stood");
    if (!standing) standing = side;
  }
  if (!standing) refuse("no foot stands during the whole step");
  Feet out;
  out.standing = *standing;
  const std::size_t fast = index_of(*standing), moving = index_of(other(*standing));
  out.at = old[fast]->frame;
  if (old[moving]) out.from = out.at.inverse() * old[moving]->frame;
  if (now[moving]) out.to = out.at.inverse() * now[moving]->frame;
  out.moves = placed[moving] || !old[moving] || !now[moving];
  return out;
}

}  // namespace foothold::bioloid::check

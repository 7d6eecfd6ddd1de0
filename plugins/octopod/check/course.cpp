// Pieces of the motion one after the other.
#include "octopod/check/course.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "octopod/check/balance.hpp"

namespace foothold::octopod {
namespace {

constexpr double kLook = 0.1;            // m: farther away than that nothing matters
constexpr double kSpeedRounding = 1e-6;  // part of the speed limit
constexpr double kAngleRounding = 1e-9;  // m, of clearances
constexpr int kDeepest = 14;             // halvings of a piece

// Where a foot is at a point of the motion.
enum class Foothold { kAir, kFrom, kTo, kBoth };
constexpr bool meets(Foothold a, Foothold b) {
  return a != Foothold::kAir && b != Foothold::kAir && (a == b || a == Foothold::kBoth || b == Foothold::kBoth);
}

struct Point {
  double time = 0.0;
  Pose pose;
  Skeleton at;
  std::array<Foothold, kLegs> feet{};
};

Point point_of(const Setting& setting, const MotionPoint& given, const Feet& from, const Feet& to) {
  if (given.joints.size() != kJoints)
    refuse("the motion at ", given.time, " s gives ", given.joints.size(), " joints, not ", kJoints);
  Point out{given.time, {given.base, given.joints}, skeleton(setting.model, given.base, given.joints), {}};
  for (std::size_t k = 0; k < kLegs; ++k) {
    const bool old = (out.at.limbs[k].foot - from[k].point).norm() <= judge::kPoseTolerance;
    const bool fresh = (out.at.limbs[k].foot - to[k].point).norm() <= judge::kPoseTolerance;
    out.feet[k] = old && fresh ? Foothold::kBoth : old ? Foothold::kFrom : fresh ? Foothold::kTo : Foothold::kAir;
  }
  return out;
}

std::string when(const Point& a, const Point& b) {
  std::ostringstream out;
  out << "the motion between " << a.time << " and " << b.time << " s";
  return out.str();
}

void judge_speed(const Setting& setting, const Point& a, const Point& b) {
  const double time = b.time - a.time;
  if (!(time > 0.0)) refuse(when(a, b), ": time does not go on");
  for (std::size_t k = 0; k < kJoints; ++k) {
    const double speed = std::abs(b.pose.joints[k] - a.pose.joints[k]) / time;
    if (!(speed <= setting.model.joint_speed * (1.0 + kSpeedRounding)))
      refuse(when(a, b), ": joint ", k, " turns with ", speed, " rad/s, may with ", setting.model.joint_speed);
  }
}

// The feet that carry over the whole piece hold the robot wherever its centre of mass can be.
void judge_balance(const Setting& setting, const Point& a, const Point& b, const Feet& from, const Feet& to, const Ways& ways) {
  std::vector<contact::Contact> carrying;
  std::string names;
  for (std::size_t k = 0; k < kLegs; ++k) {
    if (!meets(a.feet[k], b.feet[k])) continue;
    const bool old = a.feet[k] == Foothold::kFrom || b.feet[k] == Foothold::kFrom;
    carrying.push_back(old ? from[k] : to[k]);
    names += " " + limb(static_cast<int>(k));
  }
  const double side = std::sqrt(2.0) * ways.bulge_of_centre_of_mass();
  for (const Point* end : {&a, &b})
    for (const auto& [x, y] : {std::pair{side, 0.0}, {-side, 0.0}, {0.0, side}, {0.0, -side}}) {
      const Vector3d at = end->at.centre_of_mass + Vector3d(x, y, 0.0);
      if (!balanced(carrying, at, setting.options.friction, setting.cone()))
        refuse(when(a, b), ": no equilibrium on", names.empty() ? " no feet" : names, " at friction ", setting.options.friction);
    }
}

// One body or foot over a piece: never nearer than `least`, from distances at the ends less half the way; else in halves.
template <class Distance, class Way>
void judge_piece(const Setting& setting, const Pose& a, const Pose& b, double at_a, double at_b, double least, int depth,
                 const Distance& distance_at, const Way& way_of, const std::string& what) {
  if (0.5 * (at_a + at_b - way_of(Ways(setting.model, a, b))) >= least) return;
  if (depth == kDeepest) refuse(what, " comes nearer to the ground than ", least, " m, or so near that it cannot be ruled out");
  const Pose middle = between(a, b, 0.5);
  const double at_middle = distance_at(skeleton(setting.model, middle.base, middle.joints));
  if (!(at_middle >= least)) refuse(what, " comes to ", at_middle, " m to the ground, ", least, " m must be kept");
  judge_piece(setting, a, middle, at_a, at_middle, least, depth + 1, distance_at, way_of, what);
  judge_piece(setting, middle, b, at_middle, at_b, least, depth + 1, distance_at, way_of, what);
}

void judge_bodies(const Setting& setting, const Point& a, const Point& b) {
  const Ways ways(setting.model, a.pose, b.pose);
  const double least = std::max(setting.options.clearance - kAngleRounding, kAngleRounding);
  for (int body = 0; body < kBodies; ++body) {
    const auto away = [&](const Skeleton& at) { return body_distance(setting.model, at, body, setting.triangles, kLook); };
    const auto way = [&](const Ways& piece) { return piece.of_body(body); };
    judge_piece(setting, a.pose, b.pose, away(a.at), away(b.at), least, 0, away, way, when(a, b) + ": " + body_name(body));
  }
}

void judge_foot(const Setting& setting, const Point& a, const Point& b, std::size_t k, const Ways& ways, Course& course) {
  const std::string what = when(a, b) + ": foot " + limb(static_cast<int>(k));
  const bool carries = meets(a.feet[k], b.feet[k]);
  const auto way = [&](const Ways& piece) { return piece.of_foot(static_cast<int>(k)); };
  const auto away = [&](const Skeleton& at) {
    const Skeleton::Limb& limb = at.limbs[k];
    return foot_distance(setting, limb.foot, limb.ankle, kLook);
  };
  if (!carries && a.feet[k] != Foothold::kAir && b.feet[k] != Foothold::kAir)
    refuse(what, " is dragged from one contact to the other");
  if (!carries) {
    // Between points of which one is a contact the sole leaves it on a line that it can bulge off only less than it rises.
    for (const auto& [on, off] : {std::pair{&a, &b}, {&b, &a}}) {
      if (on->feet[k] == Foothold::kAir) continue;
      const double height = rise(setting, on->at.limbs[k].foot, off->at.limbs[k].foot);
      const double bulge = ways.bulge_of_foot(static_cast<int>(k));
      if (!(height >= 4.0 * bulge)) refuse(what, " leaves or meets the ground at ", height, " m, with a bulge of ", bulge, " m");
    }
  } else {
    const double slip = ways.bulge_of_foot(static_cast<int>(k));
    if (!(slip <= kSlip)) refuse(what, " carries, but can be ", slip, " m beside its contact");
    course.slip = std::max(course.slip, slip);
    const Vector3d sole = a.at.limbs[k].foot;
    const auto outside = [&](const Skeleton& at) { return rise(setting, sole, at.limbs[k].ankle); };
    judge_piece(setting, a.pose, b.pose, outside(a.at), outside(b.at), kAngleRounding, 0, outside, way, what);
  }
  judge_piece(setting, a.pose, b.pose, away(a.at), away(b.at), kAngleRounding, 0, away, way, what);
}

}  // namespace

double judge_clear(const Setting& setting, const Skeleton& at, const std::string& where) {
  double least = kLook;
  for (int body = 0; body < kBodies; ++body) {
    const double away = body_distance(setting.model, at, body, setting.triangles, kLook);
    if (!(away > 0.0)) refuse(where, ": ", body_name(body), " cuts the ground");
    if (!(away >= setting.options.clearance - kAngleRounding))
      refuse(where, ": ", body_name(body), " is ", away, " m from the ground, ", setting.options.clearance, " m must be kept");
    least = std::min(least, away);
  }
  for (std::size_t k = 0; k < kLegs; ++k) {
    const Skeleton::Limb& foot = at.limbs[k];
    const std::string name = limb(static_cast<int>(k));
    if (const double up = rise(setting, foot.foot, foot.ankle); !(up > 0.0))
      refuse(where, ": foot ", name, " comes from below the ground, its ankle is ", -up, " m deep");
    if (!(foot_distance(setting, foot.foot, foot.ankle, kLook) > 0.0)) refuse(where, ": foot ", name, " cuts the ground");
  }
  return least;
}

Course judge_course(const Setting& setting, const Step& step, const Posture& before, const Feet& from, const Feet& to) {
  if (step.motion.size() < 2) refuse("a motion has two points at least, not ", step.motion.size());
  const auto same = [](const MotionPoint& point, const Posture& posture, const char* what) {
    double off = judge::error_between(point.base, posture.base);
    for (std::size_t k = 0; k < kJoints; ++k) off = std::max(off, std::abs(point.joints[k] - posture.joints[k]));
    if (!(off <= judge::kSame)) refuse("the motion ", what, " ", off, " m or rad beside the posture");
  };
  Course course{kLook, 0.0};
  Point last = point_of(setting, step.motion.front(), from, to);
  same(step.motion.front(), before, "begins");
  if (last.time != 0.0) refuse("the motion begins at ", last.time, " s, not at 0");
  for (std::size_t i = 1; i < step.motion.size(); ++i) {
    Point next = point_of(setting, step.motion[i], from, to);
    judge_speed(setting, last, next);
    const Ways ways(setting.model, last.pose, next.pose);
    if (setting.options.stability) judge_balance(setting, last, next, from, to, ways);
    judge_bodies(setting, last, next);
    for (std::size_t k = 0; k < kLegs; ++k) judge_foot(setting, last, next, k, ways, course);
    for (int body = 0; body < kBodies; ++body)
      course.clearance = std::min(course.clearance, body_distance(setting.model, next.at, body, setting.triangles, kLook));
    last = std::move(next);
  }
  same(step.motion.back(), step.after, "ends");
  return course;
}

}  // namespace foothold::octopod

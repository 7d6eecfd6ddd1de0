// Pieces of the motion one after the other.
#include "octopod/check/course.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "octopod/check/carrying.hpp"
#include "octopod/check/itself.hpp"

namespace foothold::octopod {
namespace {

constexpr double kLook = 0.1;            // m: farther away than that nothing matters
constexpr double kSpeedRounding = 1e-6;  // part of the speed limit
constexpr double kRounding = 1e-9;       // m, of clearances
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

// What is known of a distance (m) at the last point: not more than it is.
struct Bound {
  double known = 0.0;
  bool exact = false;
};

// From `a` to `b`, never nearer than `least`: by distances at the ends less half the way between them; else in halves.
template <class Distance, class Way>
void judge_piece(const Setting& setting, const Pose& a, const Pose& b, double at_a, double at_b, double way, double least,
                 int depth, const Distance& distance_at, const Way& way_of, const std::string& what, const std::string& other) {
  if (0.5 * (at_a + at_b - way) >= least) return;
  if (depth == kDeepest) refuse(what, " comes nearer to ", other, " than ", least, " m, or so near that it cannot be ruled out");
  const Pose middle = between(a, b, 0.5);
  const double at_middle = distance_at(skeleton(setting.model, middle.base, middle.joints));
  if (!(at_middle >= least)) refuse(what, " comes to ", at_middle, " m to ", other, ", ", least, " m must be kept");
  judge_piece(setting, a, middle, at_a, at_middle, way_of(Ways(setting.model, a, middle)), least, depth + 1, distance_at, way_of,
              what, other);
  judge_piece(setting, middle, b, at_middle, at_b, way_of(Ways(setting.model, middle, b)), least, depth + 1, distance_at, way_of,
              what, other);
}

// Whether a height stays above 0 from `a` to `b`, found out in the same way.
template <class Height, class Way>
bool stays_above(const Setting& setting, const Pose& a, const Pose& b, double at_a, double at_b, double way, int depth,
                 const Height& height_at, const Way& way_of) {
  if (0.5 * (at_a + at_b - way) > 0.0) return true;
  if (depth == kDeepest) return false;
  const Pose middle = between(a, b, 0.5);
  const double at_middle = height_at(skeleton(setting.model, middle.base, middle.joints));
  return at_middle > 0.0 &&
         stays_above(setting, a, middle, at_a, at_middle, way_of(Ways(setting.model, a, middle)), depth + 1, height_at, way_of) &&
         stays_above(setting, middle, b, at_middle, at_b, way_of(Ways(setting.model, middle, b)), depth + 1, height_at, way_of);
}

// Takes the bound on from `a` to `b`. What was far away needs no look until its ways have used that up, down to `needed` (m); what
// comes nearer is looked at. Returns the distance at `b` where it was looked at, else infinity.
template <class Distance, class Way>
double judge_bound(Bound& bound, const Setting& setting, const Point& a, const Point& b, const Ways& ways, double least,
                   double needed, const Distance& distance_at, const Way& way_of, const char* part, const std::string& name,
                   const std::string& other = "the ground") {
  const double way = way_of(ways);
  if (bound.known - way >= needed) {
    bound = {bound.known - way, false};
    return HUGE_VAL;
  }
  const double at_a = bound.exact ? bound.known : distance_at(a.at), at_b = distance_at(b.at);
  const std::string what = when(a, b) + ": " + part + name;
  if (!(at_b >= least)) refuse(what, " comes to ", at_b, " m to ", other, ", ", least, " m must be kept");
  judge_piece(setting, a.pose, b.pose, at_a, at_b, way, least, 0, distance_at, way_of, what, other);
  bound = {at_b, true};
  return at_b;
}

class Walk {
 public:
  Walk(const Setting& setting, const Feet& from, const Feet& to) : setting_(setting), feet_{from, to}, carrying_(setting) {
    for (std::size_t k = 0; k < kLegs; ++k) {
      seats_[0][k] = seat_of(setting, from[k].point);
      seats_[1][k] = seat_of(setting, to[k].point);
    }
  }

  void piece(const Point& a, const Point& b) {
    judge_speed(setting_, a, b);
    const Ways ways(setting_.model, a.pose, b.pose);
    bodies(a, b, ways);
    apart(a, b);
    std::array<std::uint8_t, kLegs> standing{};
    Feet contacts;
    for (std::size_t k = 0; k < kLegs; ++k) {
      const int seat = foot(a, b, k, ways);
      standing[k] = static_cast<std::uint8_t>(seat + 1);
      if (seat >= 0) contacts[k] = feet_[static_cast<std::size_t>(seat)][k];
    }
    if (setting_.options.stability)
      carrying_.add(a.time, b.time, standing, contacts, a.at.centre_of_mass, b.at.centre_of_mass, ways.bulge_of_centre_of_mass());
  }

  Course finish() {
    carrying_.finish();
    return course_;
  }

 private:
  void bodies(const Point& a, const Point& b, const Ways& ways) {
    const double least = std::max(setting_.options.clearance - kRounding, kRounding);
    for (int body = 0; body < kBodies; ++body) {
      const auto away = [&](const Skeleton& at) { return body_distance(setting_.model, at, body, setting_.triangles, kLook); };
      const auto way = [&](const Ways& piece) { return piece.of_body(body); };
      const double at_b = judge_bound(bodies_[static_cast<std::size_t>(body)], setting_, a, b, ways, least,
                                      std::max(least, course_.clearance), away, way, "", body_name(body));
      course_.clearance = std::min(course_.clearance, at_b);
    }
  }

  // As module A sees it: nothing that moves all of the robot brings its parts nearer to each other.
  void apart(Point a, Point b) {
    a.pose.base = b.pose.base = Isometry3d::Identity();
    const Ways ways(setting_.model, a.pose, b.pose);
    const double least = std::max(setting_.options.clearance - kRounding, kRounding);
    for (std::size_t k = 0; k < kPairs; ++k) {
      const Parts& parts = parts_apart()[k];
      const auto away = [&](const Skeleton& at) { return parts_distance(setting_.model, at, parts, kLook); };
      const auto way = [&](const Ways& piece) { return piece.of_body(parts.a) + piece.of_body(parts.b); };
      const double at_b = judge_bound(pairs_[k], setting_, a, b, ways, least, std::max(least, course_.apart), away, way, "",
                                      body_name(parts.a), body_name(parts.b));
      course_.apart = std::min(course_.apart, at_b);
    }
  }

  // -1: in the air; else 0 or 1 as it carries on its contact before or after.
  int foot(const Point& a, const Point& b, std::size_t k, const Ways& ways) {
    const std::string name = limb(static_cast<int>(k));
    const bool carries = meets(a.feet[k], b.feet[k]);
    if (!carries && a.feet[k] != Foothold::kAir && b.feet[k] != Foothold::kAir)
      refuse(when(a, b), ": foot ", name, " is dragged from one contact to the other");
    const auto way = [&](const Ways& piece) { return piece.of_foot(static_cast<int>(k)); };
    const double bulge = ways.bulge_of_foot(static_cast<int>(k));
    if (!carries && a.feet[k] == Foothold::kAir && b.feet[k] == Foothold::kAir) {
      if (std::exchange(seated_[k], -1) != -1) distances_[k] = {};
      const auto away = [&](const Skeleton& at) { return flying_distance(setting_, at.limbs[k].foot, at.limbs[k].ankle, kLook); };
      judge_bound(distances_[k], setting_, a, b, ways, kRounding, kRounding, away, way, "foot ", name);
      return -1;
    }
    const bool before = a.feet[k] == Foothold::kFrom || b.feet[k] == Foothold::kFrom;
    const int which = before ? 0 : 1;
    const Seat& seat = seats_[static_cast<std::size_t>(which)][k];
    if (std::exchange(seated_[k], which) != which) distances_[k] = rises_[k] = {};
    const auto beside = [&](const Skeleton& at) { return standing_distance(seat, at.limbs[k].foot, at.limbs[k].ankle, kLook); };
    judge_bound(distances_[k], setting_, a, b, ways, kRounding, kRounding, beside, way, "foot ", name);
    if (!carries) {
      leave(a, b, k, seat, ways.of_foot(static_cast<int>(k)), bulge);
      return -1;
    }
    if (!(bulge <= kSlip)) refuse(when(a, b), ": foot ", name, " carries, but can be ", bulge, " m beside its contact");
    course_.slip = std::max(course_.slip, bulge);
    const auto outside = [&](const Skeleton& at) { return rise(seat, at.limbs[k].ankle); };
    judge_bound(rises_[k], setting_, a, b, ways, kRounding, kRounding, outside, way, "the ankle of foot ", name);
    return which;
  }

  // One end of the piece stands on its seat, the other is in the air. The sole goes off its chord by no more than 4 s (1 - s)
  // bulges at part s of the way, so that one that rises 4 bulges above a plane never goes below it; the ankle stays above the same
  // plane.
  void leave(const Point& a, const Point& b, std::size_t k, const Seat& seat, double way, double bulge) {
    const bool lifts = b.feet[k] == Foothold::kAir;
    const Skeleton::Limb& off = (lifts ? b : a).at.limbs[k];
    const auto clears = [&](const Triangle* t) {
      const auto height = [&](const Vector3d& p) { return t->normal.dot(p - seat.sole); };
      const auto of_ankle = [&](const Skeleton& at) { return height(at.limbs[k].ankle); };
      const auto way_of = [&](const Ways& piece) { return piece.of_foot(static_cast<int>(k)); };
      return height(off.foot) >= 4.0 * bulge && stays_above(setting_, a.pose, b.pose, height(a.at.limbs[k].ankle),
                                                            height(b.at.limbs[k].ankle), way, 0, of_ankle, way_of);
    };
    const bool clear = seat.hollow ? std::all_of(seat.under.begin(), seat.under.end(), clears)
                                   : std::any_of(seat.under.begin(), seat.under.end(), clears);
    if (!clear)
      refuse(when(a, b), ": foot ", limb(static_cast<int>(k)), lifts ? " leaves" : " meets", " its contact at a height of ",
             rise(seat, off.foot), " m only, with a bulge of ", bulge, " m");
  }

  const Setting& setting_;
  std::array<Feet, 2> feet_;
  std::array<std::array<Seat, kLegs>, 2> seats_;
  Carrying carrying_;
  std::array<Bound, kBodies> bodies_;
  std::array<Bound, kPairs> pairs_;
  std::array<Bound, kLegs> distances_, rises_;
  std::array<int, kLegs> seated_{-2, -2, -2, -2, -2, -2, -2, -2};  // which seat the bounds above are of
  Course course_{kLook, kLook, 0.0};
};

}  // namespace

double judge_clear(const Setting& setting, const Skeleton& at, const std::string& where) {
  double least = kLook;
  for (int body = 0; body < kBodies; ++body) {
    const double away = body_distance(setting.model, at, body, setting.triangles, kLook);
    if (!(away > 0.0)) refuse(where, ": ", body_name(body), " cuts the ground");
    if (!(away >= setting.options.clearance - kRounding))
      refuse(where, ": ", body_name(body), " is ", away, " m from the ground, ", setting.options.clearance, " m must be kept");
    least = std::min(least, away);
  }
  for (std::size_t k = 0; k < kLegs; ++k) {
    const Skeleton::Limb& foot = at.limbs[k];
    const Seat seat = seat_of(setting, foot.foot);
    if (const double up = rise(seat, foot.ankle); !(up > 0.0))
      refuse(where, ": foot ", limb(static_cast<int>(k)), " comes from below the ground, its ankle is ", -up, " m deep");
    if (!(standing_distance(seat, foot.foot, foot.ankle, kLook) > 0.0))
      refuse(where, ": foot ", limb(static_cast<int>(k)), " cuts the ground");
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
  Walk walk(setting, from, to);
  Point last = point_of(setting, step.motion.front(), from, to);
  same(step.motion.front(), before, "begins");
  if (last.time != 0.0) refuse("the motion begins at ", last.time, " s, not at 0");
  for (std::size_t i = 1; i < step.motion.size(); ++i) {
    Point next = point_of(setting, step.motion[i], from, to);
    walk.piece(last, next);
    last = std::move(next);
  }
  same(step.motion.back(), step.after, "ends");
  return walk.finish();
}

}  // namespace foothold::octopod

// The order of the check: contacts, postures, times and speeds, then every line of the motion.
#include "bioloid/check/check.hpp"

#include <algorithm>
#include <cmath>

#include "bioloid/check/feet.hpp"
#include "bioloid/check/line.hpp"
#include "judge/refusal.hpp"

namespace foothold::bioloid {
namespace {

using namespace check;
using judge::refuse;

Joints joints_of(const std::vector<double>& sent, const char* where) {
  if (sent.size() != kJoints) refuse(where, " has ", sent.size(), " joints, the robot 18");
  const Joints out = Eigen::Map<const Joints>(sent.data());
  if (!out.allFinite()) refuse(where, " has a joint that is not finite");
  return out;
}

class StepCheck {
 public:
  StepCheck(const Model& model, std::span<const Prism> obstacles, const Step& step, const Posture& before,
            const CheckOptions& options)
      : model_(model),
        step_(step),
        before_(before),
        options_(options),
        feet_(feet_of(step, before)),
        skeleton_(model, feet_.standing),
        surroundings_(model, skeleton_, obstacles, feet_.at, feet_.standing),
        judged_{model_, options_, skeleton_, surroundings_, other(feet_.standing)} {}

  std::vector<Margin> run() {
    posture(before_, feet_.from, "the posture before");
    posture(step_.after, feet_.to, "the posture after");
    read_motion();
    for (std::size_t i = 0; i < points_.size(); ++i) point(i);
    for (std::size_t i = 1; i < points_.size(); ++i) lines_.push_back(line(i));
    Distances distances(judged_);
    distances.next(points_[0].instant, points_[0].time, nullptr, &lines_[0], seen_);
    for (std::size_t i = 1; i < points_.size(); ++i) {
      const Line& before = lines_[i - 1];
      const Support support(model_, before.stands);
      for (const Point* end : {&points_[i - 1], &points_[i]}) balanced(*end, support);
      distances.next(points_[i].instant, points_[i].time, &before, i + 1 < points_.size() ? &lines_[i] : nullptr, seen_);
      prove(judged_, before, support, distances.open(), seen_);
    }
    return margins();
  }

 private:
  struct Point {
    double time = 0.0;
    Joints joints;
    Instant instant;
    bool old = false, now = false;  // the other sole stands there
  };

  void within_limits(const Joints& joints, const std::string& where) {
    for (std::size_t j = 0; j < kJoints; ++j) {
      const double angle = joints[static_cast<int>(j)];
      const kinematics::Interval& limits = model_.joints[j].limits;
      limits_ = std::min({limits_, angle - limits.low, limits.high - angle});
      if (!limits.holds(angle, judge::kSame))
        refuse(where, ": ", name_at(kJointNames, j), " is at ", angle, " rad, outside [", limits.low, ", ", limits.high, "]");
    }
  }

  void base_agrees(const Isometry3d& base, const Instant& instant, const std::string& where) const {
    const Isometry3d torso = feet_.at * instant.moved[0] * Eigen::Translation3d(skeleton_.torso());
    if (!(judge::error_between(base, torso) <= judge::kPoseTolerance))
      refuse(where, ": the base is ", judge::apart(base, torso), " m and ", judge::turned(base, torso),
             " rad from where the joints and ", name_at(kLimbs, index_of(feet_.standing)), " have it");
  }

  void posture(const Posture& at, const std::optional<Isometry3d>& contact, const std::string& where) {
    const Joints joints = joints_of(at.joints, where.c_str());
    within_limits(joints, where);
    const Instant instant = skeleton_.at(joints);
    base_agrees(at.base, instant, where);
    if (!contact) return;
    const Isometry3d sole = other_sole(judged_, instant);
    if (!(judge::error_between(sole, *contact) <= judge::kPoseTolerance))
      refuse(where, ": the joints bring ", name_at(kLimbs, index_of(judged_.moving)), " ", judge::apart(sole, *contact), " m and ",
             judge::turned(sole, *contact), " rad from its contact");
  }

  void read_motion() {
    if (step_.motion.size() < 2) refuse("the step has no motion");
    const auto same = [](const Posture& posture, const MotionPoint& sent, const char* what) {
      const Joints a = joints_of(posture.joints, what), b = joints_of(sent.joints, what);
      if (const double off = (a - b).cwiseAbs().maxCoeff(); off > judge::kSame)
        refuse("the motion's ", what, " is ", off, " rad from the posture");
    };
    same(before_, step_.motion.front(), "begin");
    same(step_.after, step_.motion.back(), "end");
    if (step_.motion.front().time != 0.0) refuse("the motion begins at ", step_.motion.front().time, " s, not at 0");
    for (const MotionPoint& sent : step_.motion) {
      const std::string where = "at " + std::to_string(sent.time) + " s";
      Point point{sent.time, joints_of(sent.joints, where.c_str()), {}};
      within_limits(point.joints, where);
      point.instant = skeleton_.at(point.joints);
      base_agrees(sent.base, point.instant, where);
      if (!points_.empty()) speeds(points_.back(), point);
      points_.push_back(std::move(point));
    }
  }

  void speeds(const Point& a, const Point& b) {
    if (!(b.time > a.time) || !std::isfinite(b.time)) refuse("the motion's times do not grow: ", b.time, " s after ", a.time, " s");
    for (std::size_t j = 0; j < kJoints; ++j) {
      const double share =
          std::abs(b.joints[static_cast<int>(j)] - a.joints[static_cast<int>(j)]) / (b.time - a.time) / model_.joints[j].speed;
      speed_ = std::max(speed_, share);
      if (share > options_.speed * (1.0 + judge::kSame))
        refuse("from ", a.time, " s to ", b.time, " s: ", name_at(kJointNames, j), " turns at ", share,
               " of its servo's speed, more than ", options_.speed);
    }
  }

  // Where the other foot is at a point.
  void point(std::size_t i) {
    Point& at = points_[i];
    const Isometry3d sole = other_sole(judged_, at.instant);
    const auto stands = [&](const std::optional<Isometry3d>& place) {
      return place && judge::error_between(sole, *place) <= options_.slip;
    };
    at.old = stands(feet_.from);
    at.now = stands(feet_.to);
    if (at.old || at.now) return;
    const std::string name = name_at(kLimbs, index_of(judged_.moving));
    if (!feet_.moves)
      refuse("at ", at.time, " s: the standing ", name, " slips by ", judge::apart(sole, *feet_.from), " m and ",
             judge::turned(sole, *feet_.from), " rad, more than ", options_.slip);
    if (const double height = lowest_corner(judged_, at.instant); !(height > 0.0))
      refuse("at ", at.time, " s: ", name,
             " neither stands at its old or new place nor is above the ground: its lowest corner is at ", height, " m");
  }

  // From point i - 1 to i.
  Line line(std::size_t i) const {
    const Point &a = points_[i - 1], &b = points_[i];
    std::optional<Isometry3d> stands;
    if (a.old && b.old)
      stands = feet_.from;
    else if (a.now && b.now)
      stands = feet_.to;
    else if ((a.old || a.now) && (b.old || b.now))
      refuse("from ", a.time, " s to ", b.time, " s: ", name_at(kLimbs, index_of(judged_.moving)),
             " changes its place without a point in the air");
    Line out = line_between(judged_, a.joints, b.joints);
    out.begin = a.time;
    out.end = b.time;
    out.stands = stands;
    return out;
  }

  void balanced(const Point& at, const Support& support) {
    const double margin = support.margin(at.instant.centre_of_mass);
    seen_.balance = std::min(seen_.balance, margin);
    if (margin < options_.balance - judge::kPoseTolerance)
      refuse("at ", at.time, " s: the centre of mass is ", margin, " m inside the soles' hull, less than ", options_.balance, " m");
  }

  std::vector<Margin> margins() const {
    std::vector<Margin> out{{"clearance", seen_.clearance, options_.clearance, "m"},
                            {"balance", seen_.balance, options_.balance, "m"},
                            {"limits", limits_, 0.0, "rad"},
                            {"speed", options_.speed - speed_, 0.0, "1"}};
    if (seen_.slip < HUGE_VAL) out.push_back({"slip", seen_.slip, 0.0, "m"});
    if (seen_.ground < HUGE_VAL) {
      out.push_back({"ground", seen_.ground, -options_.ground, "m"});
      out.push_back({"lift", seen_.lift, 0.0, "m"});
    }
    return out;
  }

  const Model& model_;
  const Step& step_;
  const Posture& before_;
  const CheckOptions& options_;
  Feet feet_;
  Skeleton skeleton_;
  Surroundings surroundings_;
  Judged judged_;
  std::vector<Point> points_;
  std::vector<Line> lines_;
  Seen seen_;
  double limits_ = HUGE_VAL, speed_ = 0.0;
};

}  // namespace

StepVerdict check_step(const Model& model, std::span<const Prism> obstacles, const Step& step, const Posture& before,
                       const CheckOptions& options) {
  try {
    return {true, {}, StepCheck(model, obstacles, step, before, options).run()};
  } catch (const judge::Refusal& refusal) {
    return {false, refusal.reason, {}};
  }
}

}  // namespace foothold::bioloid

// Thousands of spoilt steps: none is accepted that a judge of another make refuses.
//
// The other judge looks twenty times between two points by the planner's own kinematics; the ground is a plane, so heights are
// exact, and where legs touch is sampled. It has a little more tolerance than the judge under test.
#include <cstdlib>
#include <functional>

#include "contact/nesm.hpp"
#include "steps.hpp"

namespace foothold::hexpiderix::testing {
namespace {

constexpr double kLoose = 1.5e-6;  // m and rad
constexpr double kStray = 1.5e-3;  // m, between points
constexpr int kLooks = 20;

double height(const Vector3d& p) { return p.z() * std::cos(kSlope) + p.x() * std::sin(kSlope); }

struct Leg {
  Vector3d hip, knee, ankle, foot;
};
using LegsAt = std::array<Leg, kLegs>;

LegsAt legs_at(const Coordinates& at) {
  LegsAt out;
  for (std::size_t leg = 0; leg < kLegs; ++leg) {
    const LegPoints points = leg_points(shipped_model(), leg, at.legs[leg]);
    const Vector3d knee = at.thorax * points.knee, foot = at.thorax * points.foot;
    out[leg] = {at.thorax * points.hip, knee, foot + shipped_model().toe / shipped_model().leg.tibia * (knee - foot), foot};
  }
  return out;
}

bool bodies_apart(const Coordinates& at, const LegsAt& legs) {
  const Model& m = shipped_model();
  for (std::size_t corner = 0; corner < 6; ++corner)
    for (const double side : {-0.5, 0.5}) {
      const double angle = static_cast<double>(corner) * std::numbers::pi / 3;
      const Vector3d vertex(m.thorax_width / 2 * std::cos(angle), m.thorax_width / 2 * std::sin(angle), side * m.thorax_height);
      if (height(at.thorax * vertex) < -kLoose) return false;
    }
  constexpr int kAlong = 6;
  const auto on_leg = [&](const Leg& leg, int k) {
    return k < kAlong ? Vector3d(leg.hip + k * (leg.knee - leg.hip) / kAlong)
                      : Vector3d(leg.knee + (k - kAlong) * (leg.foot - leg.knee) / kAlong);
  };
  for (std::size_t i = 0; i < kLegs; ++i) {
    for (const Vector3d& p : {legs[i].hip, legs[i].knee, legs[i].ankle})
      if (height(p) < m.leg_radius - kLoose) return false;
    if (height(legs[i].foot) < -kStray) return false;
    for (std::size_t j = i + 1; j < kLegs; ++j)
      for (int a = 0; a <= 2 * kAlong; ++a)
        for (int b = 0; b <= 2 * kAlong; ++b)
          if ((on_leg(legs[i], a) - on_leg(legs[j], b)).norm() < 2 * m.leg_radius - kLoose) return false;
  }
  return true;
}

// NESM on the feet that are within `off` of a foothold of either posture; less than three are none.
double nesm_of(const Coordinates& at, const LegsAt& legs, const std::vector<const Posture*>& postures, double off) {
  std::vector<Vector3d> feet;
  for (std::size_t leg = 0; leg < kLegs; ++leg) {
    bool stands = false;
    for (const Posture* posture : postures)
      for (const Contact& contact : posture->stance)
        stands = stands ||
                 (contact.limb == "L" + std::to_string(leg + 1) && (contact.frame.translation() - legs[leg].foot).norm() <= off);
    if (stands) feet.push_back(legs[leg].foot);
  }
  if (feet.size() < 3) return -1.0;
  return contact::nesm(contact::support_polygon(feet), at.thorax * centre_of_mass(shipped_model(), at.legs)).value;
}

bool within(const std::vector<double>& joints) {
  if (joints.size() != 18) return false;
  for (std::size_t k = 0; k < joints.size(); ++k)
    if (!shipped_model().limits[k % 3].holds(joints[k], kLoose)) return false;
  return true;
}

bool after_stands(const Judged& judged) {
  const Posture& after = judged.step.after;
  if (!within(after.joints)) return false;
  const Coordinates at = from_posture(after);
  const LegsAt legs = legs_at(at);
  Footholds feet;
  for (const Contact& contact : after.stance) {
    if (contact.limb.size() != 2 || contact.limb[1] < '1' || contact.limb[1] > '6') return false;
    const auto leg = static_cast<std::size_t>(contact.limb[1] - '1');
    if (feet.supports[leg] || (legs[leg].foot - contact.frame.translation()).norm() > kLoose) return false;
    if (std::abs(height(contact.frame.translation())) > kLoose) return false;
    if ((contact.frame.linear().col(2) - Vector3d(std::sin(kSlope), 0, std::cos(kSlope))).norm() > kLoose) return false;
    feet.supports[leg] = true;
    feet.points[leg] = contact.frame.translation();
    feet.normals[leg] = contact.frame.linear().col(2);
  }
  return nesm_of(at, legs, {&after}, kLoose) > -1e-9 && bodies_apart(at, legs) &&
         friction_needed(feet, at.thorax * centre_of_mass(shipped_model(), at.legs)) <= 1.001 * judged.options.friction;
}

bool same(const MotionPoint& point, const Posture& posture) {
  double most = std::max((point.base.translation() - posture.base.translation()).norm(),
                         (point.base.linear() - posture.base.linear()).norm() / 2);
  for (std::size_t j = 0; j < 18; ++j) most = std::max(most, std::abs(point.joints[j] - posture.joints[j]));
  return most <= kLoose;
}

bool way_holds(const Judged& judged) {
  const std::vector<MotionPoint>& motion = judged.step.motion;
  if (motion.empty()) return true;
  for (const MotionPoint& point : motion)
    if (!within(point.joints)) return false;
  if (!same(motion.front(), judged.before) || !same(motion.back(), judged.step.after)) return false;
  for (std::size_t k = 1; k < motion.size(); ++k) {
    const MotionPoint &a = motion[k - 1], &b = motion[k];
    if (b.time < a.time) return false;
    for (std::size_t j = 0; j < 18; ++j)
      if (std::abs(b.joints[j] - a.joints[j]) > shipped_model().joint_speed * (b.time - a.time) + kLoose) return false;
    for (int look = 0; look < kLooks; ++look) {
      const double part = static_cast<double>(look) / kLooks;
      Posture now{a.base, a.joints, {}};
      now.base.translation() += part * (b.base.translation() - a.base.translation());
      now.base.linear() = Eigen::Quaterniond(a.base.linear()).slerp(part, Eigen::Quaterniond(b.base.linear())).toRotationMatrix();
      for (std::size_t j = 0; j < 18; ++j) now.joints[j] += part * (b.joints[j] - a.joints[j]);
      const Coordinates at = from_posture(now);
      const LegsAt legs = legs_at(at);
      // Both postures of the sound steps are stable, so that the way must be.
      if (nesm_of(at, legs, {&judged.before, &judged.step.after}, kStray) < -5e-4) return false;
      if (look % 5 == 0 && !bodies_apart(at, legs)) return false;
    }
  }
  return true;
}

struct Spoil {
  const char* name;
  std::function<void(Judged&, std::mt19937_64&, double)> by;
};

template <class Container>
auto& any_of(Container& all, std::mt19937_64& random) {
  return all[random() % all.size()];
}

Vector3d direction(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  return Vector3d(normal(random), normal(random), normal(random)).normalized();
}

const std::vector<Spoil>& spoils() {
  static const std::vector<Spoil> all{
      {"joint after", [](Judged& w, auto& r, double by) { any_of(w.step.after.joints, r) += by; }},
      {"joint after, and at the motion's end",
       [](Judged& w, auto& r, double by) {
         const auto j = r() % 18;
         w.step.after.joints[j] += by;
         w.step.motion.back().joints[j] += by;
       }},
      {"joint after, without motion",
       [](Judged& w, auto& r, double by) {
         any_of(w.step.after.joints, r) += by;
         w.step.motion.clear();
       }},
      {"base after", [](Judged& w, auto& r, double by) { w.step.after.base.translation() += by * direction(r); }},
      {"base turned", [](Judged& w, auto& r, double by) { w.step.after.base.rotate(Eigen::AngleAxisd(by, direction(r))); }},
      {"contact", [](Judged& w, auto& r, double by) { any_of(w.step.after.stance, r).frame.translation() += by * direction(r); }},
      {"contact turned",
       [](Judged& w, auto& r, double by) { any_of(w.step.after.stance, r).frame.rotate(Eigen::AngleAxisd(by, direction(r))); }},
      {"contact's leg", [](Judged& w, auto& r, double) { any_of(w.step.after.stance, r).limb = "L" + std::to_string(r() % 8); }},
      {"contact gone",
       [](Judged& w, auto& r, double) {
         w.step.after.stance.erase(w.step.after.stance.begin() + static_cast<long>(r() % w.step.after.stance.size()));
       }},
      {"joint on the way", [](Judged& w, auto& r, double by) { any_of(any_of(w.step.motion, r).joints, r) += by; }},
      {"joint on the way, slowly",
       [](Judged& w, auto& r, double by) {
         for (MotionPoint& point : w.step.motion) point.time *= 1e6;
         any_of(any_of(w.step.motion, r).joints, r) += by;
       }},
      {"base on the way", [](Judged& w, auto& r, double by) { any_of(w.step.motion, r).base.translation() += by * direction(r); }},
      {"base turned on the way",
       [](Judged& w, auto& r, double by) { any_of(w.step.motion, r).base.rotate(Eigen::AngleAxisd(by, direction(r))); }},
      {"time", [](Judged& w, auto& r, double by) { any_of(w.step.motion, r).time += by; }},
      {"points gone",
       [](Judged& w, auto& r, double) {
         const auto from = static_cast<long>(r() % w.step.motion.size());
         const auto count = static_cast<long>(1 + r() % 4);
         const auto end = std::min(from + count, static_cast<long>(w.step.motion.size()) - 1);
         if (from < end) w.step.motion.erase(w.step.motion.begin() + from, w.step.motion.begin() + end);
       }},
      {"points swapped", [](Judged& w, auto& r, double) { std::swap(any_of(w.step.motion, r), any_of(w.step.motion, r)); }},
      {"less friction", [](Judged& w, auto&, double by) { w.options.friction = std::abs(by); }},
      {"begins elsewhere", [](Judged& w, auto& r, double by) { any_of(w.before.joints, r) += by; }},
  };
  return all;
}

TEST(SpoiltSteps, AreNeverAcceptedWhereADenseJudgeRefuses) {
  const int count = std::getenv("FOOTHOLD_LONG") != nullptr ? 40'000 : 3'000;
  std::vector<Judged> sound = walked();
  sound.push_back(adapted());
  sound.push_back(joined());
  for (const Judged& step : sound) ASSERT_TRUE(after_stands(step) && way_holds(step)) << step.step.label;
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> exponent(-6.5, 0.0);
  int accepted = 0, refused = 0;
  for (int i = 0; i < count; ++i) {
    Judged spoilt = any_of(sound, random);
    const Spoil& spoil = any_of(spoils(), random);
    const double by = std::pow(10.0, exponent(random)) * (random() % 2 ? 1.0 : -1.0);
    spoil.by(spoilt, random, by);
    const StepVerdict verdict = verdict_of(spoilt);
    if (!verdict.accepted) {
      ++refused;
      EXPECT_FALSE(verdict.reason.empty());
      continue;
    }
    ++accepted;
    EXPECT_TRUE(after_stands(spoilt)) << spoil.name << " by " << by << ": " << spoilt.step.label;
    EXPECT_TRUE(way_holds(spoilt)) << spoil.name << " by " << by << ": " << spoilt.step.label;
  }
  std::printf("%d spoilt steps refused, %d accepted, all of these by the dense judge, too\n", refused, accepted);
  EXPECT_GT(refused, count / 2);
  EXPECT_GT(accepted, count / 50);
}

}  // namespace
}  // namespace foothold::hexpiderix::testing

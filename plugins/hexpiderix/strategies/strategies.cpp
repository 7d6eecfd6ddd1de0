// Constant orientation and geometric strategy, and the choice.
#include "hexpiderix/strategies/strategies.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "hexpiderix/strategies/orientation.hpp"

namespace foothold::hexpiderix {
namespace {

// A pair of a triad's legs whose line the thorax turns about, and which of its axes that is (paper, Figures 7 and 8).
struct SupportLine {
  std::size_t a, b;
  bool about_y;
};
constexpr std::array<SupportLine, 3> kLines1{{{2, 4, true}, {4, 0, false}, {0, 2, false}}};
constexpr std::array<SupportLine, 3> kLines2{{{1, 3, false}, {3, 5, false}, {5, 1, true}}};

std::string degrees(double radians) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f deg", radians * 180.0 / std::numbers::pi);
  return text;
}

// The line between the legs whose heights over the horizontal differ least.
SupportLine most_level(const Model& model, const Situation& from, const Joints& legs) {
  const auto height = [&](std::size_t leg) { return (from.thorax.linear() * leg_points(model, leg, legs[leg]).foot).z(); };
  const auto& lines = from.footholds.supports == kTriad1 ? kLines1 : kLines2;
  SupportLine best = lines[0];
  for (const SupportLine& line : lines)
    if (std::abs(height(line.a) - height(line.b)) < std::abs(height(best.a) - height(best.b)) - 1e-9) best = line;
  return best;
}

Adapted better(Adapted a, Adapted b) { return b.stable() && b.evaluation.margin > a.evaluation.margin ? b : a; }

}  // namespace

const char* name(Adapted::Strategy strategy) {
  switch (strategy) {
    case Adapted::Strategy::kNone:
      return "none";
    case Adapted::Strategy::kConstantOrientation:
      return "constant orientation";
    case Adapted::Strategy::kGeometric:
      return "geometric";
    case Adapted::Strategy::kEmergency:
      return "emergency";
  }
  return "";
}

double leg_height(const Model& model, const Vector3d& joints) {
  return model.leg.drop - model.leg.femur * std::sin(joints[1]) - model.leg.tibia * std::sin(joints[1] + joints[2]);
}

Evaluation as_it_stands(const Model& model, const Situation& from) {
  return evaluate(model, from.ground, from.footholds, from.thorax, {model.lift, false}, from.clearance);
}

Adapted constant_orientation(const Model& model, const Situation& from) {
  const Orientation now = orientation_of(from.thorax);
  const Isometry3d level = turned(from.thorax, {.roll = 0.0, .pitch = 0.0, .yaw = now.yaw});
  return {Adapted::Strategy::kConstantOrientation, from.footholds,
          evaluate(model, from.ground, from.footholds, level, {model.lift, false}, from.clearance),
          "level, from roll " + degrees(now.roll) + " and pitch " + degrees(now.pitch)};
}

Adapted geometric(const Model& model, const Situation& from, double share) {
  Adapted out{Adapted::Strategy::kGeometric, from.footholds, {}, ""};
  if (from.footholds.supports != kTriad1 && from.footholds.supports != kTriad2) {
    out.about = "needs the legs of one triad on the ground, and no other";
    return out;
  }
  const Evaluation now = as_it_stands(model, from);
  if (now.fault == Evaluation::Fault::kReach) {
    out.evaluation = now;
    out.about = "the legs do not reach as it stands";
    return out;
  }
  const SupportLine line = most_level(model, from, now.at.legs);
  Orientation to = orientation_of(from.thorax);
  double& angle = line.about_y ? to.pitch : to.roll;
  const double turn = share * angle;
  angle -= turn;
  out.evaluation = evaluate(model, from.ground, from.footholds, turned(from.thorax, to), {model.lift, true}, from.clearance);
  out.about = std::string(line.about_y ? "Y" : "X") + " axis by " + degrees(turn) + ", support line L" +
              std::to_string(line.a + 1) + "-L" + std::to_string(line.b + 1);
  return out;
}

Adapted chosen(const Model& model, const Situation& from) {
  Adapted stay{Adapted::Strategy::kNone, from.footholds, as_it_stands(model, from), "stable as it stands"};
  if (stay.stable()) return stay;
  Adapted none{Adapted::Strategy::kNone, from.footholds, {}, ""};
  const Adapted best = better(better(none, constant_orientation(model, from)), geometric(model, from));
  if (best.stable()) return best;
  return emergency(model, from, EmergencyRule::kLongestDistance);
}

}  // namespace foothold::hexpiderix

// Half turns, differences between postures, and refusals in words.
#include "octopod/posture/posture.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>
#include <utility>

#include "octopod/posture/apart.hpp"

namespace foothold::octopod {
namespace {

double angle_between(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) {
  const double cosine = (a.cwiseProduct(b).sum() - 1.0) / 2.0;
  // Near 0 the cosine has lost the angle's digits, the difference has not: |a - b|^2 = 8 sin^2(angle / 2).
  if (cosine > 0.9) return 2 * std::asin(std::min(1.0, (a - b).norm() / std::sqrt(8.0)));
  return std::acos(std::clamp(cosine, -1.0, 1.0));
}

// Of angles within (-pi, pi].
double squared_turn(double a, double b) {
  double turn = std::abs(a - b);
  if (turn > std::numbers::pi) turn = 2 * std::numbers::pi - turn;
  return turn * turn;
}

// A leg or a body as it is called with A and B exchanged.
int exchanged(int part) { return part < kLegs ? kLegs - 1 - part : kBodyOfA + kBodyOfB - part; }

std::string named(int part) {
  if (part < kLegs) return limb(part);
  return part == kBodyOfA ? "the body of A" : "the body of B";
}

}  // namespace

Built turned(const Model& model, const Built& built) {
  const Eigen::Matrix3d half = Vector3d(-1, -1, 1).asDiagonal();
  Built out = built;
  const Coordinates& at = built.standing.at;
  out.standing.at.front = built.standing.rear;
  out.standing.at.front.linear() = built.standing.rear.linear() * half;
  out.standing.at.ball = Eigen::Quaterniond(half * at.ball.toRotationMatrix().transpose() * half);
  for (std::size_t i = 0; i < kLegs; ++i) {
    const Vector3d& joints = at.legs[kLegs - 1 - i];
    out.standing.at.legs[i] = {-joints[0], joints[1], joints[2]};
    out.standing.feet[i] = built.standing.feet[kLegs - 1 - i];
  }
  out.standing.rear = rear(model, out.standing.at);
  if (built.leg >= 0) out.leg = exchanged(built.leg);
  if (built.other >= 0) out.other = exchanged(built.other);
  // Legs are named before bodies, and in their order.
  if (out.other >= 0 && out.leg > out.other) std::swap(out.leg, out.other);
  return out;
}

double change(const Standing& a, const Standing& b, const ChangeWeights& weights, double enough) {
  double sum = weights.place * ((a.at.front.translation() - b.at.front.translation()).norm() +
                                (a.rear.translation() - b.rear.translation()).norm());
  if (sum >= enough) return sum;
  double joints = 0.0;
  for (std::size_t i = 0; i < kLegs; ++i)
    for (Eigen::Index k = 0; k < 3; ++k) joints += squared_turn(a.at.legs[i][k], b.at.legs[i][k]);
  sum += weights.joints * std::sqrt(joints);
  if (sum >= enough) return sum;
  return sum + weights.orientation *
                   (angle_between(a.at.front.linear(), b.at.front.linear()) + angle_between(a.rear.linear(), b.rear.linear()));
}

std::string reason(const Built& built) {
  std::ostringstream out;
  const std::string leg = built.leg < 0 ? "a body" : "leg " + named(built.leg);
  switch (built.hindrance) {
    case Hindrance::kNone:
      return "";
    case Hindrance::kNoGround:
      return built.leg < 0 ? "no ground beneath" : "no ground for " + leg;
    case Hindrance::kOutOfReach:
      out << leg << " misses its foothold by " << built.figure << " m";
      break;
    case Hindrance::kNotConverged:
      out << leg << " is still " << built.figure << " m from its foothold after the last step";
      break;
    case Hindrance::kCollision:
      out << leg << " touches the ground";
      if (built.figure > 0.0) out << " or comes nearer than " << built.figure << " m";
      break;
    case Hindrance::kSelfContact:
      out << named(built.leg) << " and " << named(built.other) << " are nearer to each other than " << built.figure << " m";
      break;
  }
  return out.str();
}

}  // namespace foothold::octopod

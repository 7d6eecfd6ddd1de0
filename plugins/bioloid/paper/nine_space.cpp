// Nine joints, judged by the search's judge.
#include "bioloid/paper/nine_space.hpp"

#include <algorithm>
#include <cmath>

namespace foothold::bioloid::paper {
namespace {

constexpr double kGrain = 0.05;       // rad between the postures of a movement: coupled joints do not move on a line
constexpr double kOneHeading = 1e-9;  // rad

// Limits of the nine free joints, in their order.
void put_limits(const Model& model, Side support, Space& space) {
  const auto put = [&](int row, Side side, std::size_t k) {
    const kinematics::Interval& limits = model.joints[leg_joint(side, k)].limits;
    space.low[row] = limits.low;
    space.high[row] = limits.high;
  };
  for (std::size_t k = 0; k < kLegJoints; ++k) put(static_cast<int>(k), support, k);
  for (std::size_t k = 1; k < 4; ++k) put(static_cast<int>(k + 5), other(support), k);
}

}  // namespace

Point nine_point(const Model& model, Side support, const Joints& joints, int dimension) {
  Point out(dimension);
  out.head(9) = free_joints(joints, support);
  if (dimension > 9) out[9] = heading_of(model, support, joints);
  return out;
}

bool joints_at(const Model& model, Side support, const Point& point, double heading, Joints& joints) {
  return couple(model, support, Nine(point.head(9)), point.size() > 9 ? point[9] : heading, joints);
}

Space nine_space(const Model& model, Judge& judge, const Support& support, const Joints& a, const Joints& b,
                 const NineOptions& options) {
  const double from = heading_of(model, support.foot, a), to = heading_of(model, support.foot, b);
  const int dimension = std::abs(from - to) <= kOneHeading ? 9 : 10;
  Space out{.low = Point(dimension),
            .high = Point(dimension),
            .step = Point::Constant(dimension, options.step),
            .valid = {},
            .joins = {},
            .place = {},
            .equal = options.equal};
  put_limits(model, support.foot, out);
  if (dimension > 9) {
    out.low[9] = std::min(from, to);
    out.high[9] = std::max(from, to);
  }
  const auto posture = [&model, foot = support.foot, from](const Point& point, Joints& joints) {
    return joints_at(model, foot, point, from, joints);
  };
  out.valid = [&judge, support, posture](const Point& point) {
    Joints joints;
    return posture(point, joints) && judge.posture(joints, support) == Fault::kNone;
  };
  if (options.certified)
    out.joins = [&judge, support, posture](const Point& p, const Point& q) {
      const int parts = std::max(1, static_cast<int>(std::ceil((q - p).cwiseAbs().maxCoeff() / kGrain)));
      Joints last, next;
      if (!posture(p, last)) return false;
      for (int k = 1; k <= parts; ++k, last = next)
        if (!posture(p + static_cast<double>(k) / parts * (q - p), next) || judge.motion(last, next, support) != Fault::kNone)
          return false;
      return true;
    };
  out.place = [&model, foot = support.foot, posture](const Point& point) -> Point {
    Joints joints;
    if (!posture(point, joints)) return Point::Constant(3, HUGE_VAL);
    return (sole_in_torso(model, foot, joints).inverse() * sole_in_torso(model, other(foot), joints)).translation();
  };
  return out;
}

Error balance_error(const Model& model, Judge& judge, const Support& support, double heading) {
  return [&model, &judge, support, heading](const Point& point) {
    Joints joints;
    return joints_at(model, support.foot, point, heading, joints) ? judge.balance(joints, support).error : HUGE_VAL;
  };
}

}  // namespace foothold::bioloid::paper

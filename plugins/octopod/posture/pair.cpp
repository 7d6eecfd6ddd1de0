// Bodies that follow their feet.
#include "octopod/posture/pair.hpp"

#include <cmath>

namespace foothold::octopod {
namespace {

constexpr double kBend = 0.005;        // 1, part of the reach that a settled leg keeps in its knee
constexpr double kSettled = 1e-7;      // m
constexpr int kSteps = 40;             // Newton converges in 2 to 6 where it does
constexpr double kTurnLength = 0.15;   // m/rad: about a shoulder's distance from C, so a turn weighs as much as it moves
constexpr double kDamping = 1e-6;      // 1: keeps rows that say the same apart
constexpr double kLongestStep = 0.05;  // m

Eigen::Matrix3d turned_by(const Vector3d& rotation) {
  const double angle = rotation.norm();
  if (angle == 0.0) return Eigen::Matrix3d::Identity();
  return Eigen::AngleAxisd(angle, rotation / angle).toRotationMatrix();
}

// x of (rows rows^T + damping) x = right by Cholesky, in place. `count` rows.
using Row = Eigen::Matrix<double, 9, 1>;
void solve(const std::array<Row, kLegs>& rows, std::size_t count, std::array<double, kLegs>& right) {
  std::array<std::array<double, kLegs>, kLegs> lower{};
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      double sum = rows[i].dot(rows[j]) + (i == j ? kDamping : 0.0);
      for (std::size_t k = 0; k < j; ++k) sum -= lower[i][k] * lower[j][k];
      lower[i][j] = i == j ? std::sqrt(sum) : sum / lower[j][j];
    }
    for (std::size_t k = 0; k < i; ++k) right[i] -= lower[i][k] * right[k];
    right[i] /= lower[i][i];
  }
  for (std::size_t i = count; i-- > 0;) {
    for (std::size_t k = i + 1; k < count; ++k) right[i] -= lower[k][i] * right[k];
    right[i] /= lower[i][i];
  }
}

}  // namespace

Pair pair_of(const Model& model, const Coordinates& at) {
  return {centre(model, at), {at.front.linear(), at.front.linear() * at.ball.toRotationMatrix()}};
}

std::optional<Coordinates> reaching(const Model& model, const Pair& pair, const std::array<Vector3d, kLegs>& feet) {
  Coordinates out;
  out.front = module_pose(model, pair, 0);
  out.ball = Eigen::Quaterniond(pair.turn[0].transpose() * pair.turn[1]);
  const std::array<Isometry3d, 2> modules{out.front, module_pose(model, pair, 1)};
  for (int leg = 0; leg < kLegs; ++leg) {
    const auto i = static_cast<std::size_t>(leg);
    const Isometry3d& module = modules[i / 4];
    const auto joints = natural_leg(model, leg, module.linear().transpose() * (feet[i] - module.translation()));
    if (!joints) return std::nullopt;
    out.legs[i] = *joints;
  }
  return out;
}

Miss settle(const Model& model, const std::array<Vector3d, kLegs>& feet, double farthest, Pair& pair) {
  const double wanted = model.reach() * (1.0 - kBend);
  const Vector3d began = pair.joint;
  Miss miss;
  for (int step = 0; step <= kSteps; ++step) {
    std::array<Row, kLegs> rows;
    std::array<double, kLegs> over{};
    std::size_t count = 0;
    for (int leg = 0; leg < kLegs; ++leg) {
      const auto i = static_cast<std::size_t>(leg), m = i / 4;
      const Vector3d arm = pair.turn[m] * lever(model, leg), to_foot = feet[i] - pair.joint - arm;
      const double distance = to_foot.norm();
      if (distance <= wanted + kSettled) continue;
      if (step == 0 && distance - wanted > miss.by) miss = {leg, distance - wanted};
      const Vector3d along = to_foot / distance, turning = -arm.cross(along) / kTurnLength;
      rows[count].setZero();
      rows[count].head<3>() = -along;
      rows[count].segment<3>(m == 0 ? 3 : 6) = turning;
      over[count++] = distance - wanted;
    }
    if (count == 0) return {};
    solve(rows, count, over);
    Row move = Row::Zero();
    for (std::size_t k = 0; k < count; ++k) move -= over[k] * rows[k];
    const double longest = move.cwiseAbs().maxCoeff();
    if (longest > kLongestStep) move *= kLongestStep / longest;
    pair.joint += move.head<3>();
    pair.turn[0] = turned_by(move.segment<3>(3) / kTurnLength) * pair.turn[0];
    pair.turn[1] = turned_by(move.segment<3>(6) / kTurnLength) * pair.turn[1];
    if ((pair.joint - began).norm() > farthest) break;
  }
  return miss;
}

}  // namespace foothold::octopod

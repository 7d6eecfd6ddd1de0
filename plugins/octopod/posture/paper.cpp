// Standing up as the paper does it (sections 3 and 5.1): footholds by the k-d tree over centroids, then Newton's method over both
// bodies and all joints at once. Slow and not exact; kept to be compared with.
#include <Eigen/Cholesky>
#include <cmath>
#include <numbers>

#include "octopod/posture/start.hpp"
#include "terrain/centroids.hpp"

namespace foothold::octopod {
namespace {

constexpr double kRadius = 1.5;    // of the stretched leg: centroids so near to the shoulder are looked at (paper)
constexpr double kClosed = 1e-10;  // m, of every equation
constexpr int kMostSteps = 50;
constexpr Eigen::Index kEquations = 27, kUnknowns = 36;

// The 36 unknowns. A module's rotation changes by a rotation vector in the world.
struct Unknowns {
  std::array<Vector3d, 2> place;
  std::array<Eigen::Matrix3d, 2> turn;
  std::array<Vector3d, kLegs> legs;
};

Eigen::Matrix3d cross(const Vector3d& v) {
  Eigen::Matrix3d out;
  out << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return out;
}

// Both ends of the ball joint together, each foot on its foothold; and how that changes with the unknowns.
void equations(const Model& model, const Unknowns& at, const std::array<Footing, kLegs>& feet, Eigen::VectorXd& open,
               Eigen::MatrixXd& slope) {
  slope.setZero();
  const Vector3d front_end = at.turn[0] * Vector3d(-model.arm(), 0, 0), rear_end = at.turn[1] * Vector3d(model.arm(), 0, 0);
  open.head<3>() = at.place[0] + front_end - at.place[1] - rear_end;
  slope.block<3, 3>(0, 0).setIdentity();
  slope.block<3, 3>(0, 3) = -cross(front_end);
  slope.block<3, 3>(0, 6) = -Eigen::Matrix3d::Identity();
  slope.block<3, 3>(0, 9) = cross(rear_end);
  for (int leg = 0; leg < kLegs; ++leg) {
    const auto i = static_cast<std::size_t>(leg), m = i / 4;
    const Eigen::Index row = 3 + 3 * leg, module = 6 * module_of(leg);
    const Vector3d foot = at.turn[m] * leg_in_module(model, leg, at.legs[i]).foot;
    open.segment<3>(row) = at.place[m] + foot - feet[i].point;
    slope.block<3, 3>(row, module).setIdentity();
    slope.block<3, 3>(row, module + 3) = -cross(foot);
    slope.block<3, 3>(row, 12 + 3 * leg) = at.turn[m] * leg_jacobian(model, leg, at.legs[i]);
  }
}

void move(Unknowns& at, const Eigen::VectorXd& step) {
  for (std::size_t m = 0; m < 2; ++m) {
    const Eigen::Index k = 6 * static_cast<Eigen::Index>(m);
    at.place[m] += step.segment<3>(k);
    const Vector3d turn = step.segment<3>(k + 3);
    if (const double angle = turn.norm(); angle > 0) at.turn[m] = Eigen::AngleAxisd(angle, turn / angle) * at.turn[m];
  }
  for (std::size_t i = 0; i < kLegs; ++i) at.legs[i] += step.segment<3>(12 + 3 * static_cast<Eigen::Index>(i));
}

Unknowns right_angles(const Model& model, const Pair& pair) {
  Unknowns out;
  for (const int m : {0, 1}) {
    out.place[static_cast<std::size_t>(m)] = module_pose(model, pair, m).translation();
    out.turn[static_cast<std::size_t>(m)] = pair.turn[static_cast<std::size_t>(m)];
  }
  out.legs.fill({0, 0, -std::numbers::pi / 2});
  return out;
}

Coordinates coordinates(const Unknowns& at) {
  Coordinates out;
  out.front.linear() = at.turn[0];
  out.front.translation() = at.place[0];
  out.ball = Eigen::Quaterniond(at.turn[0].transpose() * at.turn[1]);
  for (std::size_t i = 0; i < kLegs; ++i)
    out.legs[i] = at.legs[i].unaryExpr([](double angle) { return std::remainder(angle, 2 * std::numbers::pi); });
  return out;
}

}  // namespace

Built stand_paper(const Model& model, const terrain::Surface& surface, const terrain::CentroidTree& centroids, const Vector3d& node,
                  const Vector3d& normal, int axis, double clearance) {
  Built out;
  const std::optional<Pair> pair = bodies_over(model, surface, node, normal, axis);
  out.hindrance = Hindrance::kNoGround;
  if (!pair) return out;
  for (int leg = 0; leg < kLegs; ++leg) {
    const terrain::Nearest found =
        centroids.foothold(foot_in_the_air(model, *pair, leg), shoulder(model, *pair, leg), kRadius * model.reach());
    out.leg = leg;
    if (found.triangle < 0) return out;
    out.standing.feet[static_cast<std::size_t>(leg)] = {
        found.point, surface.terrain().normals[static_cast<std::size_t>(found.triangle)], found.triangle};
  }
  Unknowns at = right_angles(model, *pair);
  Eigen::VectorXd open(kEquations);
  Eigen::MatrixXd slope(kEquations, kUnknowns);
  for (int step = 0; step <= kMostSteps; ++step) {
    equations(model, at, out.standing.feet, open, slope);
    if (!open.allFinite() || step == kMostSteps || open.cwiseAbs().maxCoeff() < kClosed) break;
    // The shortest of the steps that solve the linear equations: there are nine more unknowns.
    Eigen::MatrixXd normal_matrix = slope * slope.transpose();
    normal_matrix.diagonal().array() += 1e-14;
    move(at, -(slope.transpose() * normal_matrix.ldlt().solve(open)));
  }
  if (!(open.cwiseAbs().maxCoeff() < kClosed)) {
    Eigen::Index worst = 0;
    out.figure = open.tail(kEquations - 3).cwiseAbs().maxCoeff(&worst);
    out.leg = static_cast<int>(worst / 3);
    out.hindrance = Hindrance::kNotConverged;
    return out;
  }
  out.leg = -1;
  out.standing.at = coordinates(at);
  complete(model, surface, clearance, false, out);
  return out;
}

}  // namespace foothold::octopod

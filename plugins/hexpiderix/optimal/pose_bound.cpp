// Bounds over boxes of poses, by how far points can be from where they are at the box' middle.
#include "hexpiderix/optimal/pose_bound.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace foothold::hexpiderix {
namespace {

// At most how much the direction of a vector of this length turns if its end moves by `radius`, rad.
double turn_of(double length, double radius) { return radius < length ? std::asin(radius / length) : std::numbers::pi; }

constexpr double kLiftStep = 5e-4;  // m, of the table of lifted legs

// A leg's masses, kg: servos at its three joints, brackets halved between their ends.
struct Masses {
  explicit Masses(const Model& model)
      : coxa(model.servo_mass),
        hip(model.servo_mass + model.femur_mass / 2),
        knee(hip + model.tibia_mass / 2),
        foot(model.tibia_mass / 2) {}
  double coxa, hip, knee, foot;
};

double side_opposite(double a, double b, double angle) { return std::sqrt(a * a + b * b - 2.0 * a * b * std::cos(angle)); }

}  // namespace

PoseBound::PoseBound(const Model& model, const Plane& ground, const Footholds& footholds, const Isometry3d& frame, double clearance)
    : model_(model), ground_(ground), footholds_(footholds), frame_(frame), clearance_(clearance) {
  const contact::SupportPolygon polygon = polygon_of(footholds, footholds.supports);
  for (std::size_t i = 0; i < polygon.count && polygon.count >= 3; ++i) {
    const Vector3d& a = polygon.corners[i];
    const Vector3d along = (polygon.corners[(i + 1) % polygon.count] - a).normalized();
    const Vector3d rise = Vector3d::UnitZ() - along.z() * along;
    edges_.push_back({a, along, rise.normalized(), Vector3d::UnitZ().cross(along).normalized(), rise.norm()});
  }
  // The knee's angle of a leg stretched and of one folded as far as q3 goes.
  const kinematics::YawLeg& leg = model.leg;
  longest_ = side_opposite(leg.femur, leg.tibia, std::numbers::pi + model.limits[2].high);
  shortest_ = side_opposite(leg.femur, leg.tibia, std::numbers::pi + model.limits[2].low);
  for (std::size_t i = 0; i < kLegs; ++i) {
    const double angle = static_cast<double>(i) * std::numbers::pi / 3, out = model.thorax_width / 2;
    corners_[i] = {out * std::cos(angle), out * std::sin(angle), -model.thorax_height / 2};
    const Vector3d coxa = leg_points(model, i, Vector3d::Zero()).coxa;
    mounts_[i] = {coxa.normalized(), Vector3d::UnitZ().cross(coxa.normalized()), coxa};
    if (!footholds.supports[i]) tabulate_swing(i);
  }
}

// A lifted foot hangs right above its place, so its leg stays in one plane and its femur turns one way: between two lifts the knee
// moves along an arc.
void PoseBound::tabulate_swing(std::size_t leg) {
  const Masses mass(model_);
  std::optional<Vector3d> before;
  for (double lift = model_.lift;; lift += kLiftStep) {
    const auto joints = reach(model_, leg, standing_foot(model_, leg) + lift * Vector3d::UnitZ());
    if (!joints) break;
    const LegPoints at = leg_points(model_, leg, *joints);
    swinging_[leg].push_back(mass.coxa * at.coxa + mass.hip * at.hip + mass.knee * at.knee + mass.foot * at.foot);
    if (before) {
      const double arc = model_.leg.femur * std::abs((*joints)[1] - (*before)[1]);
      moment_per_lift_ = std::max(moment_per_lift_, mass.knee * arc / kLiftStep + mass.foot);
    }
    greatest_lift_ = std::max(greatest_lift_, lift + kLiftStep);
    before = joints;
  }
}

Isometry3d PoseBound::pose(const PoseVector& at) const {
  Isometry3d local = Isometry3d::Identity();
  local.translation() = Vector3d(at[0], at[1], at[2]);
  local.linear() = (Eigen::AngleAxisd(at[5], Vector3d::UnitZ()) * Eigen::AngleAxisd(at[4], Vector3d::UnitY()) *
                    Eigen::AngleAxisd(at[3], Vector3d::UnitX()))
                       .toRotationMatrix();
  return frame_ * local;
}

std::optional<double> PoseBound::operator()(const PoseVector& middle, const PoseVector& half) const {
  if (edges_.empty()) return std::nullopt;
  const Isometry3d thorax = pose(middle);
  const Spread spread{std::sqrt(half[0] * half[0] + half[1] * half[1] + half[2] * half[2]),
                      std::min(half[3] + half[4] + half[5], std::numbers::pi), half[2], half[3] + half[4]};
  double lowest = std::numeric_limits<double>::infinity();
  for (const Vector3d& corner : corners_) lowest = std::min(lowest, ground_.above(thorax * corner));
  if (lowest + spread.rise + spread.tilt * corners_[0].norm() < clearance_) return std::nullopt;

  Moment sum;
  for (std::size_t leg = 0; leg < kLegs; ++leg)
    if (!(footholds_.supports[leg] ? supporting(leg, thorax, spread, sum) : swinging(leg, thorax, spread, sum)))
      return std::nullopt;
  const Vector3d body = sum.rigid / model_.mass();
  return nesm_over(thorax * body, half, spread.turn * body.norm() + sum.beside / model_.mass());
}

bool PoseBound::supporting(std::size_t leg, const Isometry3d& thorax, const Spread& spread, Moment& sum) const {
  const Vector3d foot = footholds_.points[leg];
  const auto& [out, side, coxa] = mounts_[leg];
  const Vector3d local = thorax.inverse(Eigen::Isometry) * foot, from_coxa = local - coxa;
  const double x = from_coxa.dot(out), y = from_coxa.dot(side), down = from_coxa.z() + model_.leg.drop;
  const double carried = spread.shift + spread.turn * model_.thorax_radius;  // how far the coxa's axis moves
  const double radius = carried + spread.turn * from_coxa.norm();            // how far the foot moves seen from it
  const double around = std::hypot(x, y), beyond = around - model_.leg.coxa, distance = std::hypot(beyond, down);
  // Behind its axis a foot is reached backwards, with the yaw turned by half a turn.
  const double yaw = std::atan2(y, x), yaw_turn = turn_of(around, radius);
  const double limit = std::max(-model_.limits[0].low, model_.limits[0].high);
  if (std::abs(yaw) - yaw_turn > limit && std::abs(yaw) + yaw_turn < std::numbers::pi - limit) return false;
  const bool may_be_behind = std::abs(yaw) + yaw_turn >= std::numbers::pi - limit;
  if (!may_be_behind && (distance - radius > longest_ || distance + radius < shortest_)) return false;

  const auto knee_angle = [&](double d) {
    const double clamped = std::clamp(d, shortest_, longest_);
    const double f = model_.leg.femur, t = model_.leg.tibia;
    return std::acos(std::clamp((clamped * clamped + f * f - t * t) / (2.0 * clamped * f), -1.0, 1.0));
  };
  const double angle = knee_angle(distance);
  // The femur's angle over the line to the foot falls with its distance if the tibia is longer, else it first rises.
  double angle_turn = std::max(knee_angle(distance - radius) - angle, angle - knee_angle(distance + radius));
  if (may_be_behind || model_.leg.tibia <= model_.leg.femur) angle_turn = std::numbers::pi;
  const double femur_turn = std::min(std::numbers::pi, turn_of(distance, radius) + angle_turn);
  const double lift = std::atan2(down, beyond) + angle;
  const Vector3d direction = (x * out + y * side).normalized();
  const Vector3d hip = coxa + model_.leg.coxa * direction - model_.leg.drop * Vector3d::UnitZ();
  const Vector3d knee = hip + model_.leg.femur * (std::cos(lift) * direction + std::sin(lift) * Vector3d::UnitZ());
  const double yaw_most = may_be_behind ? std::numbers::pi : yaw_turn;
  const double knee_out = model_.leg.coxa + model_.leg.femur;

  const Masses mass(model_);
  sum.rigid += mass.coxa * coxa + mass.hip * hip + mass.knee * knee + mass.foot * local;
  sum.beside += mass.hip * model_.leg.coxa * yaw_most + mass.knee * (knee_out * yaw_most + model_.leg.femur * femur_turn) +
                mass.foot * radius;
  return true;
}

bool PoseBound::swinging(std::size_t leg, const Isometry3d& thorax, const Spread& spread, Moment& sum) const {
  const Vector3d place = standing_foot(model_, leg);
  const double gain = ground_.normal.dot(thorax.linear().col(2));
  const double height = ground_.above(thorax * (place + model_.lift * Vector3d::UnitZ()));
  const double foot_spread = spread.rise + spread.tilt * (place.norm() + greatest_lift_);
  const double least_gain = gain - spread.tilt, least_missing = clearance_ - height - foot_spread;
  if (least_missing > 0.0 && least_missing > (greatest_lift_ - model_.lift) * std::min(1.0, gain + spread.tilt)) return false;
  const double most_missing = clearance_ - height + foot_spread;
  double low = model_.lift, high = model_.lift;
  if (most_missing > 0.0)
    high = least_gain > 0.0 ? std::min(greatest_lift_, model_.lift + most_missing / least_gain) : greatest_lift_;
  if (least_missing > 0.0) low = std::min(high, model_.lift + least_missing);
  // The middle of the lifts, rounded to the table's.
  const auto at =
      std::min(static_cast<std::size_t>(std::lround((0.5 * (low + high) - model_.lift) / kLiftStep)), swinging_[leg].size() - 1);
  sum.rigid += swinging_[leg][at];
  sum.beside += moment_per_lift_ * (0.5 * (high - low) + (high > low ? kLiftStep : 0.0));
  return true;
}

// Over an edge h = (|R| - R.rise) cos psi inside, minus that outside: convex inside, so greatest round the box' corners; its slope
// is 2 sin(theta / 2) cos psi, theta the angle between R and rise.
double PoseBound::nesm_over(const Vector3d& centre, const PoseVector& half, double radius) const {
  const Eigen::Matrix3d& axes = frame_.linear();
  double least = std::numeric_limits<double>::infinity();
  for (const Edge& edge : edges_) {
    const Vector3d from = centre - edge.corner;
    std::array<double, 3> aside{}, up{};
    for (std::size_t k = 0; k < 3; ++k) {
      aside[k] = half[k] * axes.col(static_cast<int>(k)).dot(edge.left);
      up[k] = half[k] * axes.col(static_cast<int>(k)).dot(edge.rise);
    }
    double most = -std::numeric_limits<double>::infinity();
    for (int corner = 0; corner < 8; ++corner) {
      double x = from.dot(edge.left), y = from.dot(edge.rise);
      for (std::size_t k = 0; k < 3; ++k) {
        x += ((corner >> k) & 1 ? 1.0 : -1.0) * aside[k];
        y += ((corner >> k) & 1 ? 1.0 : -1.0) * up[k];
      }
      const double far = std::hypot(x, y);
      const double sine = radius < far ? radius / far : 1.0;  // of how far the ball's points lie off the corner's direction
      const double cosine = radius < far ? (y / far) * std::sqrt(1.0 - sine * sine) - (std::abs(x) / far) * sine : -1.0;
      const double slope = std::sqrt(std::max(0.0, 2.0 * (1.0 - cosine)));
      // Outside, at most what the slope gains from there; right over the edge it is 0.
      most = std::max(most, x >= 0.0 ? far - y + slope * radius : x + radius >= 0.0 ? slope * radius : 0.0);
    }
    least = std::min(least, most * edge.cos_psi);
  }
  return least;
}

}  // namespace foothold::hexpiderix

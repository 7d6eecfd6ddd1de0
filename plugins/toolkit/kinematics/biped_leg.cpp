// The leg in closed form. Seen from the ankle, the hip's direction gives the ankle's roll (both knee's neighbours turn about Y
// only); what is left of the rotation is yaw, roll and one sum of pitches; the distance gives the knee; the sum gives the rest.
#include "kinematics/biped_leg.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace foothold::kinematics {
namespace {

using Eigen::Isometry3d;
using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kSlack = 1e-12;     // m, of reach: what rounding takes from a stretched leg
constexpr double kSingular = 1e-13;  // m and 1, below which a direction has no angle

double wrapped(double angle) {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  if (angle > -std::numbers::pi && angle <= std::numbers::pi) return angle;
  const double rest = std::remainder(angle, kTurn);
  return rest <= -std::numbers::pi ? rest + kTurn : rest;
}

// Lengths here are metres: nothing under- or overflows, which std::hypot would guard against at three times the price.
double length(double a, double b) { return std::sqrt(a * a + b * b); }

// Angles from Z about Y by the right hand: a turn about Y adds to them. From (x, z) to (to_x, to_z).
double turn_about_y(double x, double z, double to_x, double to_z) { return std::atan2(to_x * z - to_z * x, to_x * x + to_z * z); }

// The stretched leg's angle, and the bend from there, 0 to pi, with its functions.
struct Knee {
  double middle = 0.0, cosine_middle = 1.0, sine_middle = 0.0;
  double bend = 0.0, cosine_bend = 1.0, sine_bend = 0.0;
};

std::optional<Knee> knee_at(const BipedLeg& leg, double distance) {
  const double upper = length(leg.thigh.x(), leg.thigh.z()), lower = length(leg.shin.x(), leg.shin.z());
  const double stretched = upper + lower, folded = std::abs(upper - lower);
  if (!(distance <= stretched + kSlack && distance >= folded - kSlack)) return std::nullopt;
  // From its half: the cosine law would lose half of the digits at the stretched and at the folded leg.
  const double to_stretched = std::max(0.0, (stretched - distance) * (stretched + distance));
  const double to_folded = std::max(0.0, (distance - folded) * (distance + folded));
  const double sine = std::sqrt(to_stretched), cosine = std::sqrt(to_folded), sum = to_stretched + to_folded;
  Knee out;
  out.middle = turn_about_y(leg.shin.x(), leg.shin.z(), leg.thigh.x(), leg.thigh.z());
  out.cosine_middle = (leg.thigh.x() * leg.shin.x() + leg.thigh.z() * leg.shin.z()) / (upper * lower);
  out.sine_middle = (leg.thigh.x() * leg.shin.z() - leg.thigh.z() * leg.shin.x()) / (upper * lower);
  out.bend = 2.0 * std::atan2(sine, cosine);
  out.cosine_bend = (to_folded - to_stretched) / sum;
  out.sine_bend = 2.0 * sine * cosine / sum;
  return out;
}

// One turn of the ankle's roll: +1 with the hip over the ankle, -1 under it.
struct Turned {
  double ankle_roll = 0.0;
  Matrix3d rest;  // Rz(yaw) Rx(roll) Ry(sum of pitches)
};

Turned turned(const Isometry3d& ankle, double over) {
  const Vector3d hip = -(ankle.linear().transpose() * ankle.translation());
  const double off = length(hip.y(), hip.z());
  double cosine = over, sine = 0.0;
  if (off > kSingular) {
    cosine = over * hip.z() / off;
    sine = over * hip.y() / off;
  }
  Turned out;
  out.ankle_roll = std::atan2(sine, cosine);
  out.rest.col(0) = ankle.linear().col(0);
  out.rest.col(1) = cosine * ankle.linear().col(1) - sine * ankle.linear().col(2);
  out.rest.col(2) = sine * ankle.linear().col(1) + cosine * ankle.linear().col(2);
  return out;
}

// One turn of the hip: +1 with its roll within 90 deg.
struct Hip {
  double yaw = 0.0, roll = 0.0, pitches = 0.0;
  double forward = 0.0, up = 0.0;  // of the ankle, seen from the hip behind yaw and roll
};

Hip hip_at(const Matrix3d& rest, const Vector3d& ankle, double within) {
  const double level = length(rest(0, 1), rest(1, 1));
  double cy = 1.0, sy = 0.0;
  Hip out;
  if (level > kSingular) {
    cy = within * rest(1, 1) / level;
    sy = -within * rest(0, 1) / level;
    out.yaw = std::atan2(sy, cy);
  }
  const double norm = length(level, rest(2, 1));
  const double cr = within * level / norm, sr = rest(2, 1) / norm;
  out.roll = std::atan2(sr, cr);
  // Rows 0 and 2 of Rx(-roll) Rz(-yaw), which stay exact at a roll of 90 deg.
  const Vector3d across(cy, sy, 0.0), along(sr * sy, -sr * cy, cr);
  out.pitches = std::atan2(across.dot(rest.col(2)), across.dot(rest.col(0)));
  out.forward = across.dot(ankle);
  out.up = along.dot(ankle);
  return out;
}

// `side`: +1 bends the knee by the right hand, -1 the other way.
BipedLeg::Angles angles_of(const BipedLeg& leg, const Turned& turn, const Hip& hip, const Knee& at, double side) {
  const double knee = at.middle + side * at.bend;
  const double cosine = at.cosine_middle * at.cosine_bend - side * at.sine_middle * at.sine_bend;
  const double sine = at.sine_middle * at.cosine_bend + side * at.cosine_middle * at.sine_bend;
  const double x = leg.thigh.x() + cosine * leg.shin.x() + sine * leg.shin.z();
  const double z = leg.thigh.z() - sine * leg.shin.x() + cosine * leg.shin.z();
  const double pitch = length(x, z) > kSingular ? turn_about_y(x, z, hip.forward, hip.up) : 0.0;
  BipedLeg::Angles out;
  out << hip.yaw, hip.roll, pitch, wrapped(knee), wrapped(hip.pitches - pitch - knee), turn.ankle_roll;
  return out;
}

Matrix3d about_y(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  Matrix3d out;
  out << c, 0, s, 0, 1, 0, -s, 0, c;
  return out;
}

Matrix3d about_x(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  Matrix3d out;
  out << 1, 0, 0, 0, c, -s, 0, s, c;
  return out;
}

Matrix3d about_z(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  Matrix3d out;
  out << c, -s, 0, s, c, 0, 0, 0, 1;
  return out;
}

}  // namespace

Isometry3d BipedLeg::forward(const Angles& angles) const {
  const Matrix3d upper = about_z(angles[0]) * about_x(angles[1]) * about_y(angles[2]);
  const Matrix3d lower = upper * about_y(angles[3]);
  Isometry3d out = Isometry3d::Identity();
  out.linear() = lower * about_y(angles[4]) * about_x(angles[5]);
  out.translation() = upper * thigh + lower * shin;
  return out;
}

BipedLeg::Solutions BipedLeg::inverse(const Isometry3d& ankle) const {
  Solutions out;
  const auto knee = knee_at(*this, ankle.translation().norm());
  if (!knee) return out;
  for (int branch = 0; branch < 8; ++branch) {
    const bool other_bend = branch & 1;
    if (other_bend && knee->bend == 0.0) continue;  // stretched: both bends are one
    const Turned turn = turned(ankle, branch & 2 ? -1.0 : 1.0);
    const Hip hip = hip_at(turn.rest, ankle.translation(), branch & 4 ? -1.0 : 1.0);
    const auto at = static_cast<std::size_t>(out.count++);
    out.branch[at] = branch;
    out.angles[at] = angles_of(*this, turn, hip, *knee, other_bend ? -1.0 : 1.0);
  }
  return out;
}

bool BipedLeg::standing(const Isometry3d& ankle, Angles& angles) const {
  const auto knee = knee_at(*this, ankle.translation().norm());
  if (!knee) return false;
  const Turned turn = turned(ankle, 1.0);
  angles = angles_of(*this, turn, hip_at(turn.rest, ankle.translation(), 1.0), *knee, 1.0);
  return true;
}

}  // namespace foothold::kinematics

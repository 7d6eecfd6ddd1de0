#include "hyrecro/reach/poses.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <utility>

#include "hyrecro/reach/inverse.hpp"

namespace foothold::hyrecro {
namespace {

constexpr double kPlane = 1e-6;  // m and rad

double uniform(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }
double uniform(std::mt19937_64& random, double low, double high) { return low + (high - low) * uniform(random); }

// Everything from here to inputs_of() is without branches and without the C library's arc functions: the former would be
// mispredicted every other time, the latter may differ in their last bit from machine to machine.

// Reflects (u, v) over the line through the origin at right angles to the unit vector (nu, nv), if it lies behind that line.
void fold(double& u, double& v, double nu, double nv) {
  const double behind = std::min(0.0, u * nu + v * nv);
  u -= 2.0 * behind * nu;
  v -= 2.0 * behind * nv;
}

// cos and sin of half the angle whose cosine is given. Precondition: the angle lies in [0, pi].
std::pair<double, double> half(double cosine) {
  return {std::sqrt(std::max(0.0, 0.5 * (1.0 + cosine))), std::sqrt(std::max(0.0, 0.5 * (1.0 - cosine)))};
}

// The angle in [0, pi / 2] of a cosine in [0, 1], within 2e-8 (Abramowitz and Stegun 1964, 4.4.46).
double arc(double cosine) {
  constexpr std::array<double, 8> kTerms{1.5707963050, -0.2145988016, 0.0889789874, -0.0501743046,
                                         0.0308918810, -0.0170881256, 0.0066700901, -0.0012624911};
  const double x = cosine, xx = x * x, x4 = xx * xx;
  const double low = (kTerms[0] + kTerms[1] * x) + (kTerms[2] + kTerms[3] * x) * xx;
  const double high = (kTerms[4] + kTerms[5] * x) + (kTerms[6] + kTerms[7] * x) * xx;
  return std::sqrt(std::max(0.0, 1.0 - x)) * (low + high * x4);
}

double sign(double value) { return std::copysign(1.0, value); }

NetworkInputs face_inputs(const Isometry3d& pose) {
  double x = pose(0, 3), y = pose(1, 3) * sign(pose(0, 0) * pose(1, 0));
  const double cosine = std::fabs(pose(0, 0));
  const auto [c, s] = half(cosine);
  fold(x, y, c, s);
  fold(x, y, -s, c);
  return {static_cast<float>(x), static_cast<float>(y), 0.0F, 0.0F, 0.0F, static_cast<float>(arc(cosine))};
}

NetworkInputs transition_inputs(const Isometry3d& pose) {
  double x = pose(0, 3) * sign(pose(0, 2)), z = pose(2, 3);
  const auto [c, s] = half(pose(2, 2));
  fold(x, z, s, c);
  return {static_cast<float>(x),
          static_cast<float>(std::fabs(pose(1, 3))),
          static_cast<float>(z),
          0.0F,
          static_cast<float>(2.0 * arc(c)),
          0.0F};
}

// lambda's ends for two angles, m.
double longest(const Model& m, double phi1, double phi2) {
  return m.mechanism.offsets(phi1).high + m.mechanism.offsets(phi2).high - m.core;
}
double shortest(const Model& m, double phi1, double phi2) {
  return m.mechanism.offsets(phi1).low + m.mechanism.offsets(phi2).low - m.core;
}

}  // namespace

const char* name_of(PoseKind kind) { return kind == PoseKind::kFace ? "face" : "transition"; }

std::optional<PoseKind> kind_of(const Isometry3d& pose) {
  // Of the angle between the soles' Y axes, and between their normals.
  const double across = pose(0, 1) * pose(0, 1) + pose(2, 1) * pose(2, 1);
  const double normals = pose(0, 2) * pose(0, 2) + pose(1, 2) * pose(1, 2);
  if (across < kSingular * kSingular) return PoseKind::kTransition;
  if (pose(2, 2) > 0.0 && normals < kPlane * kPlane && std::fabs(pose(2, 3)) < kPlane) return PoseKind::kFace;
  return std::nullopt;
}

NetworkInputs inputs_of(PoseKind kind, const Isometry3d& pose) {
  return kind == PoseKind::kFace ? face_inputs(pose) : transition_inputs(pose);
}

Isometry3d pose_of(const NetworkInputs& in) {
  Isometry3d out = Isometry3d::Identity();
  out.translation() = Vector3d(in[0], in[1], in[2]);
  out.linear() = (Eigen::AngleAxisd(in[5], Vector3d::UnitZ()) * Eigen::AngleAxisd(in[4], Vector3d::UnitY()) *
                  Eigen::AngleAxisd(in[3], Vector3d::UnitX()))
                     .toRotationMatrix();
  return out;
}

Isometry3d random_pose(PoseKind kind, double radius, std::mt19937_64& random) {
  using std::numbers::pi;
  Isometry3d out = Isometry3d::Identity();
  Vector3d at;
  do {
    at.x() = uniform(random, -radius, radius);
    at.y() = uniform(random, -radius, radius);
    at.z() = kind == PoseKind::kFace ? 0.0 : uniform(random, -radius, radius);
  } while (at.squaredNorm() > radius * radius);
  out.translation() = at;
  do {
    const double turn = uniform(random, -pi, pi), c = std::cos(turn), s = std::sin(turn);
    if (kind == PoseKind::kFace) {
      out.linear() << c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0;
    } else {
      const double side = (random() & 1U) != 0U ? 1.0 : -1.0;
      out.linear() << side * c, 0.0, s, 0.0, side, 0.0, -side * s, 0.0, c;
    }
  } while (kind_of(out) != kind);
  return out;
}

double farthest(PoseKind kind, const Model& m) {
  constexpr int kSteps = 200;
  const auto along = [&](int i) { return m.mechanism.greatest_phi() * (2.0 * i / kSteps - 1.0); };
  if (kind == PoseKind::kFace) {
    double shift = 0.0;
    for (int i = 0; i <= kSteps; ++i) shift = std::fmax(shift, longest(m, along(i), along(i)) * std::sin(along(i)));
    return m.hip_distance + 2.0 * shift;
  }
  // Seen from the hip plate a leg puts its sole `aside` of its hip axis and `below` the plate. For each `aside` the least and the
  // greatest `below`; two legs are farthest apart if both go aside, away from each other, at heights that differ most.
  constexpr std::size_t kBins = 200;
  const double widest = m.ankle_height + longest(m, 0.0, 0.0);
  std::array<kinematics::Interval, kBins> below;
  for (int i = 0; i <= kSteps; ++i)
    for (int j = 0; j <= kSteps; ++j)
      for (const double lambda : {shortest(m, along(i), along(j)), longest(m, along(i), along(j))}) {
        if (shortest(m, along(i), along(j)) > longest(m, along(i), along(j))) continue;
        const double psi = along(i) + along(j), phi2 = along(j);
        const double aside = m.ankle_height * std::sin(psi) + lambda * std::sin(phi2);
        const double height = m.hip_drop + lambda * std::cos(phi2) + m.ankle_height * std::cos(psi);
        kinematics::Interval& bin = below[static_cast<std::size_t>(std::fmin(kBins - 1, std::fmax(0.0, aside / widest * kBins)))];
        bin = bin.empty() ? kinematics::Interval{height, height}
                          : kinematics::Interval{std::fmin(bin.low, height), std::fmax(bin.high, height)};
      }
  double out = 0.0;
  for (std::size_t i = 0; i < kBins; ++i)
    for (std::size_t j = 0; j < kBins; ++j)
      if (!below[i].empty() && !below[j].empty())
        out = std::fmax(out,
                        std::hypot(m.hip_distance + static_cast<double>(i + j + 2) * widest / kBins, below[i].high - below[j].low));
  return out;
}

std::string robot_numbers(const Model& m) {
  std::string out;
  for (const double value : {m.mechanism.base(), m.mechanism.body(), m.mechanism.shortest(), m.mechanism.longest(), m.core,
                             m.hip_distance, m.ankle_height, m.hip_drop, m.plate.x(), m.plate.y(), m.plate.z(), m.hip_plate.x(),
                             m.hip_plate.y(), m.hip_plate.z(), m.leg_radius, m.leg_begin, m.skin}) {
    char word[32];
    std::snprintf(word, sizeof word, "%s%.9g", out.empty() ? "" : " ", value);
    out += word;
  }
  return out;
}

}  // namespace foothold::hyrecro

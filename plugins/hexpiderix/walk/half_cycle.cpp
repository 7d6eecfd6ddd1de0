// Instants of half a cycle, and what holds between them.
#include "hexpiderix/walk/half_cycle.hpp"

#include <algorithm>
#include <cmath>

namespace foothold::hexpiderix {
namespace {

constexpr int kInstants = 32;

constexpr double kSpare = 5e-4;  // m, of clearance at the instants, for what lies between them

constexpr double kMostSlip = 5e-4;  // m, of supporting feet between two instants, where all joints move evenly

// How far supporting feet stray half way between two instants.
double slip_between(const Model& model, const Coordinates& a, const Coordinates& b, const Footholds& held) {
  Isometry3d thorax = Isometry3d::Identity();
  thorax.translation() = 0.5 * (a.thorax.translation() + b.thorax.translation());
  thorax.linear() = Eigen::Quaterniond(a.thorax.linear()).slerp(0.5, Eigen::Quaterniond(b.thorax.linear())).toRotationMatrix();
  double most = 0.0;
  for (std::size_t leg = 0; leg < kLegs; ++leg)
    if (held.supports[leg])
      most = std::max(most, (thorax * leg_points(model, leg, 0.5 * (a.legs[leg] + b.legs[leg])).foot - held.points[leg]).norm());
  return most;
}

std::string millimetres(double metres) { return std::to_string(static_cast<int>(std::floor(1e3 * metres))) + " mm"; }

}  // namespace

HalfCycleJudge::HalfCycleJudge(const Model& model, const terrain::Surface& surface, const WalkOptions& options)
    : model_(model), surface_(surface), options_(options), equilibrium_(contact::FrictionCone::circular()) {}

// Up for a quarter of the time, over, and down for the last quarter.
Vector3d HalfCycleJudge::Flight::at(double part) const {
  constexpr double kRise = 0.25;
  const double over = std::clamp((part - kRise) / (1.0 - 2.0 * kRise), 0.0, 1.0);
  const double rise = std::clamp(std::min(part, 1.0 - part) / kRise, 0.0, 1.0);
  return from + over * (to - from) + rise * height * up;
}

// High enough for what the ground does between the footholds.
HalfCycleJudge::Flight HalfCycleJudge::flight(const Footholds& from, const Footholds& to, std::size_t leg) const {
  Flight out{from.points[leg], to.points[leg], (from.normals[leg] + to.normals[leg]).normalized(), options_.swing};
  constexpr int kLooks = 8;
  constexpr double kAbove = 0.2;  // m
  double bump = 0.0;
  for (int k = 0; k <= kLooks; ++k) {
    const Vector3d on_line = out.from + static_cast<double>(k) / kLooks * (out.to - out.from);
    const auto hit = surface_.ray(on_line + kAbove * out.up, -out.up, kAbove);
    if (hit) bump = std::max(bump, (hit->point - on_line).dot(out.up));
  }
  out.height += bump;
  return out;
}

std::optional<HalfCycle> HalfCycleJudge::operator()(const Stand& from, const Stand& to, Legs swinging, std::string& because) {
  ++judged_;
  HalfCycle out;
  out.swinging = swinging;
  out.to = to;
  out.least_nesm = std::numeric_limits<double>::infinity();
  const Legs supports = ~swinging;
  std::array<Flight, kLegs> flights{};
  for (std::size_t leg = 0; leg < kLegs; ++leg)
    if (swinging[leg]) flights[leg] = flight(from.feet, to.feet, leg);
  Footholds held = from.feet;
  held.supports = supports;
  const Eigen::Quaterniond q0(from.at.thorax.linear()), q1(to.at.thorax.linear());
  std::array<Vector3d, kLegs> feet = from.feet.points;
  Vector3d com_before = Vector3d::Zero();
  double nesm_before = 0.0;
  for (int k = 0; k <= kInstants; ++k) {
    const double part = static_cast<double>(k) / kInstants;
    Isometry3d thorax = Isometry3d::Identity();
    thorax.translation() = from.at.thorax.translation() + part * (to.at.thorax.translation() - from.at.thorax.translation());
    thorax.linear() = q0.slerp(part, q1).toRotationMatrix();
    for (std::size_t leg = 0; leg < kLegs; ++leg)
      if (swinging[leg]) feet[leg] = flights[leg].at(part);
    Coordinates at;
    std::size_t leg = 0;
    if (k == 0)
      at = from.at;
    else if (k == kInstants)
      at = to.at;
    else if (!place_feet(model_, thorax, feet, at, leg)) {
      because = "leg " + std::to_string(leg + 1) + " does not reach on the way";
      return std::nullopt;
    }
    Vector3d com;
    const double nesm = nesm_on(model_, at, held, supports, com);
    // NESM changes by at most twice the way of the centre of mass, which between two instants is half of what lies between them
    // from one or the other.
    const double least = k == 0 ? nesm : std::min(nesm_before, nesm) - 1.1 * (com - com_before).norm();
    out.least_nesm = std::min(out.least_nesm, least);
    if (least < options_.least_nesm) {
      because = "stability (NESM) falls to " + millimetres(least) + ", " + millimetres(options_.least_nesm) + " are demanded";
      return std::nullopt;
    }
    if (options_.friction < 100.0 && !stands(equilibrium_, held, com, options_.friction)) {
      because = "the tripod slides at friction " + std::to_string(options_.friction);
      return std::nullopt;
    }
    if (k > 0 && slip_between(model_, out.way.back(), at, held) > kMostSlip) {
      because = "a supporting leg turns too fast on the way";
      return std::nullopt;
    }
    com_before = com;
    nesm_before = nesm;
    out.way.push_back(at);
  }
  for (std::size_t k = 1; k + 1 < out.way.size(); ++k) {
    const std::string met = in_the_way(model_, surface_, out.way[k], options_.clearance + kSpare);
    if (met.empty()) continue;
    because = met + " meet";
    return std::nullopt;
  }
  for (std::size_t leg = 0; leg < kLegs; ++leg) {
    if (!swinging[leg]) continue;
    const Flight& path = flights[leg];
    // The foot's own way: the part over is clear of the ground as a whole.
    const Vector3d a = path.from + path.height * path.up, b = path.to + path.height * path.up;
    if (surface_.nearer(collision::Capsule{a, b, 0.0}, std::max(options_.clearance, 0.2 * options_.swing))) {
      because = "foot " + std::to_string(leg + 1) + " meets the ground on its way over";
      return std::nullopt;
    }
  }
  return out;
}

}  // namespace foothold::hexpiderix

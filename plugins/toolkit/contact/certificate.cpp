#include "contact/certificate.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace foothold::contact {

namespace {

// The greatest (cos a, sin a).(x, y) over the pyramid's edges, or over the circle.
double support(const Vector2d& v, FrictionCone cone) {
  if (cone.edges == 0) return v.norm();
  double best = -v.norm();
  for (int j = 0; j < cone.edges; ++j) {
    const double angle = 2.0 * std::numbers::pi * j / cone.edges;
    best = std::max(best, v.x() * std::cos(angle) + v.y() * std::sin(angle));
  }
  return best;
}

// The least mu whose cone or pyramid holds a force of unit normal component and these tangential ones.
double friction_of(const Vector2d& v, FrictionCone cone) {
  if (cone.edges == 0) return v.norm();
  double most = 0.0;
  for (int j = 0; j < cone.edges; ++j) {
    const double middle = std::numbers::pi * (2 * j + 1) / cone.edges;
    most = std::max(most, v.x() * std::cos(middle) + v.y() * std::sin(middle));
  }
  return most / std::cos(std::numbers::pi / cone.edges);
}

double greatest_distance(std::span<const Contact> contacts, const Vector3d& com) {
  double most = 0.0;
  for (const Contact& c : contacts) most = std::max(most, (c.point - com).norm());
  return most;
}

bool balances(const Verdict& verdict, std::span<const Contact> contacts, const Vector3d& com, double mu, FrictionCone cone) {
  if (verdict.forces.size() != contacts.size()) return false;
  Vector3d force = -Vector3d::UnitZ(), torque = Vector3d::Zero();
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const Vector3d& f = verdict.forces[i];
    const auto [t, b] = tangents(contacts[i].normal);
    const double normal = f.dot(contacts[i].normal);
    if (!(normal >= -kBalanceTolerance)) return false;
    if (!(friction_of({f.dot(t), f.dot(b)}, cone) <= (1.0 + kBalanceTolerance) * mu * normal + kBalanceTolerance)) return false;
    force += f;
    torque += (contacts[i].point - com).cross(f);
  }
  return force.norm() <= kBalanceTolerance && torque.norm() <= kBalanceTolerance * greatest_distance(contacts, com);
}

bool separates(const Vector6d& y, std::span<const Contact> contacts, const Vector3d& com, double mu, FrictionCone cone) {
  const double gain = y[2], reach = greatest_distance(contacts, com);
  const double size = y.head<3>().norm() + (reach > 0.0 ? reach * y.tail<3>().norm() : 0.0);
  if (!std::isfinite(size) || !(gain > kSeparationTolerance * size)) return false;
  return std::ranges::all_of(contacts, [&](const Contact& c) {
    const auto [t, b] = tangents(c.normal);
    const Vector3d v = y.head<3>() + y.tail<3>().cross(c.point - com);  // y.(f, r x f) = v.f
    return v.dot(c.normal) + mu * support({v.dot(t), v.dot(b)}, cone) <= kOverhangTolerance * gain;
  });
}

}  // namespace

bool proves(const Verdict& verdict, std::span<const Contact> contacts, const Vector3d& com, double mu, FrictionCone cone) {
  if (!verdict.proved) return false;
  return verdict.stable ? balances(verdict, contacts, com, mu, cone) : separates(verdict.separating, contacts, com, mu, cone);
}

}  // namespace foothold::contact

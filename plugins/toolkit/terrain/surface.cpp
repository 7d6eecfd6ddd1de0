// The tree's questions: nearest, rays, bodies.
#include "terrain/surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace foothold::terrain {
namespace {

constexpr double kOn = 1e-9;  // m: points this far below the surface count as on it

constexpr double kSlack = 1e-12;  // m: a vertex that hangs on a side is off it by rounding, and no ray may slip through there
constexpr double kAbove = 0.1;    // m: where plumb lines begin, above all vertices

using collision::Bounds;

std::array<Vector3d, 3> corners(const Terrain& terrain, std::uint32_t t) {
  const int k = static_cast<int>(t);
  return {terrain.corner(k, 0), terrain.corner(k, 1), terrain.corner(k, 2)};
}

std::vector<Bounds> bounds_of(const Terrain& terrain) {
  std::vector<Bounds> out;
  out.reserve(terrain.size());
  for (std::uint32_t t = 0; t < terrain.size(); ++t) out.push_back(collision::bounds_of(collision::Patch{corners(terrain, t)}));
  return out;
}

// Not more than the squared distance of anything in one to anything in the other.
double squared_apart(const Bounds& a, const Bounds& b) {
  return (a.min() - b.max()).cwiseMax(b.min() - a.max()).cwiseMax(0.0).squaredNorm();
}

// A ray in axes of its own: sheared so that it runs along the third one. (Woop, Benthin, Wald 2013: the edges' signs are then the
// same for both triangles at an edge, so no ray slips through between them.)
struct Ray {
  Ray(const Vector3d& from, const Vector3d& along) : origin(from), direction(along) {
    direction.cwiseAbs().maxCoeff(&z);
    x = (z + 1) % 3, y = (z + 2) % 3;
    shear = {direction[x] / direction[z], direction[y] / direction[z], 1.0 / direction[z]};
  }

  // Distance to the triangle; infinite if missed.
  double to(const std::array<Vector3d, 3>& corner) const {
    std::array<Vector3d, 3> p;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector3d v = corner[k] - origin;
      p[k] = {v[x] - shear.x() * v[z], v[y] - shear.y() * v[z], shear.z() * v[z]};
    }
    const auto edge = [](const Vector3d& a, const Vector3d& b) { return a.x() * b.y() - a.y() * b.x(); };
    const double u = edge(p[1], p[2]), v = edge(p[2], p[0]), w = edge(p[0], p[1]), sum = u + v + w;
    double length = 0.0;
    for (std::size_t k = 0; k < 3; ++k) length += (p[(k + 1) % 3] - p[k]).head<2>().lpNorm<1>();
    const double slack = kSlack * length;
    if (std::min({u, v, w}) < -slack && std::max({u, v, w}) > slack) return INFINITY;
    if (std::abs(sum) <= slack) return INFINITY;  // seen edge-on
    const double t = (u * p[0].z() + v * p[1].z() + w * p[2].z()) / sum;
    return t >= 0.0 ? t : INFINITY;
  }

  // Where it enters the bounds, a little widened against rounding; infinite if it misses them.
  double enters(const Bounds& bounds) const {
    double first = 0.0, last = INFINITY;
    for (Eigen::Index k = 0; k < 3; ++k) {
      const double low = bounds.min()[k] - kOn - origin[k], high = bounds.max()[k] + kOn - origin[k];
      if (direction[k] == 0.0) {
        if (low > 0.0 || high < 0.0) return INFINITY;
        continue;
      }
      const double a = low / direction[k], b = high / direction[k];
      first = std::max(first, std::min(a, b)), last = std::min(last, std::max(a, b));
    }
    return first <= last ? first : INFINITY;
  }

  Vector3d origin, direction, shear;
  Eigen::Index x = 0, y = 0, z = 0;
};

template <class Body>
double distance_to(const Terrain& terrain, const collision::BoundTree& tree, const Body& body) {
  const Bounds bounds = collision::bounds_of(body);
  return tree.least(
      INFINITY, [&](const Bounds& node) { return std::sqrt(squared_apart(node, bounds)); },
      [&](std::uint32_t t) { return collision::distance(body, collision::Patch{corners(terrain, t)}); });
}

template <class Body>
bool nearer_to(const Terrain& terrain, const collision::BoundTree& tree, const Body& body, double clearance) {
  return !tree.visit(collision::grown(collision::bounds_of(body), clearance),
                     [&](std::uint32_t t) { return !collision::nearer(body, collision::Patch{corners(terrain, t)}, clearance); });
}

}  // namespace

Surface::Surface(const Terrain& terrain) : terrain_(&terrain), tree_(bounds_of(terrain)), top_(-INFINITY) {
  for (const Vector3d& v : terrain.vertices) top_ = std::max(top_, v.z() + kAbove);
}

Nearest Surface::nearest(const Vector3d& p, Among among, double limit) const {
  Nearest best;
  const double reach = std::nextafter(limit, INFINITY);
  const double least = tree_.least(
      reach * reach, [&](const Bounds& bounds) { return bounds.squaredExteriorDistance(p); },
      [&](std::uint32_t t) {
        if (among == Among::kGround && terrain_->ground[t] == 0) return static_cast<double>(INFINITY);
        const auto [a, b, c] = corners(*terrain_, t);
        const Vector3d point = nearest_on_triangle(p, a, b, c);
        const double squared = (point - p).squaredNorm();
        if (squared < best.distance) best = {static_cast<int>(t), point, squared};
        return squared;
      });
  if (best.triangle < 0 || std::sqrt(least) > limit) return {};
  best.distance = std::sqrt(least);
  return best;
}

std::optional<Hit> Surface::ray(const Vector3d& origin, const Vector3d& direction, double length) const {
  const Ray ray(origin, direction);
  int hit = -1;
  double first = INFINITY;
  tree_.least(
      std::nextafter(length, INFINITY), [&](const Bounds& bounds) { return ray.enters(bounds); },
      [&](std::uint32_t t) {
        const double here = ray.to(corners(*terrain_, t));
        if (here < first) first = here, hit = static_cast<int>(t);
        return here;
      });
  if (hit < 0 || first > length) return std::nullopt;
  return Hit{hit, origin + first * direction, first};
}

std::optional<Hit> Surface::beneath(const Vector3d& p) const {
  std::optional<Hit> hit = ray(p + kOn * Vector3d::UnitZ(), -Vector3d::UnitZ());
  if (hit) hit->distance = std::max(0.0, hit->distance - kOn);
  return hit;
}

std::optional<double> Surface::height(double x, double y) const {
  const auto hit = ray({x, y, top_}, -Vector3d::UnitZ());
  if (!hit) return std::nullopt;
  return hit->point.z();
}

bool Surface::under(const Vector3d& p) const {
  const auto hit = ray(p + kOn * Vector3d::UnitZ(), Vector3d::UnitZ());
  return hit && terrain_->normals[static_cast<std::size_t>(hit->triangle)].z() > 0.0;
}

double Surface::distance(const Capsule& capsule) const { return distance_to(*terrain_, tree_, capsule); }
double Surface::distance(const Box& box) const { return distance_to(*terrain_, tree_, box); }
bool Surface::nearer(const Capsule& capsule, double clearance) const { return nearer_to(*terrain_, tree_, capsule, clearance); }
bool Surface::nearer(const Box& box, double clearance) const { return nearer_to(*terrain_, tree_, box, clearance); }

std::vector<int> Surface::touching(const Bounds& query) const {
  std::vector<int> out;
  tree_.visit(query, [&](std::uint32_t t) {
    out.push_back(static_cast<int>(t));
    return true;
  });
  return out;
}

}  // namespace foothold::terrain

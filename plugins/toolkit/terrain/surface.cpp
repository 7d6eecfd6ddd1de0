// The tree's questions: nearest, rays, bodies.
#include "terrain/surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace foothold::terrain {
namespace {

constexpr double kOn = 1e-9;  // m: points this far below the surface count as on it

constexpr double kSlack = 1e-12;      // m: a vertex that hangs on a side is off it by rounding, and no ray may slip through there
constexpr double kSamePlane = 1e-13;  // share by which planes' squared distances may differ by rounding
constexpr double kFar = 1e9;          // m: the end of plumb lines
constexpr double kAbove = 0.1;        // m: where plumb lines begin, above all vertices

using collision::Bounds;

std::vector<std::array<Vector3d, 3>> corners_of(const Terrain& terrain) {
  std::vector<std::array<Vector3d, 3>> out;
  out.reserve(terrain.size());
  for (int t = 0; t < static_cast<int>(terrain.size()); ++t)
    out.push_back({terrain.corner(t, 0), terrain.corner(t, 1), terrain.corner(t, 2)});
  return out;
}

std::vector<Bounds> bounds_of(std::span<const std::array<Vector3d, 3>> triangles) {
  std::vector<Bounds> out;
  out.reserve(triangles.size());
  for (const auto& corners : triangles) out.push_back(collision::bounds_of(collision::Patch{corners}));
  return out;
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

  Vector3d origin, direction, shear;
  Eigen::Index x = 0, y = 0, z = 0;
};

template <class Body>
double distance_to(std::span<const std::array<Vector3d, 3>> triangles, const collision::WideTree& tree, const Body& body) {
  return std::sqrt(tree.nearest(collision::bounds_of(body), INFINITY, [&](std::uint32_t t) {
    const double distance = collision::distance(body, collision::Patch{triangles[t]});
    return distance * distance;
  }));
}

template <class Body>
bool nearer_to(std::span<const std::array<Vector3d, 3>> triangles, const collision::WideTree& tree, const Body& body,
               double clearance) {
  return !tree.visit(collision::grown(collision::bounds_of(body), clearance),
                     [&](std::uint32_t t) { return !collision::nearer(body, collision::Patch{triangles[t]}, clearance); });
}

}  // namespace

Surface::Surface(const Terrain& terrain)
    : terrain_(&terrain), corners_(corners_of(terrain)), all_(bounds_of(corners_)), top_(-INFINITY) {
  for (const Vector3d& v : terrain.vertices) top_ = std::max(top_, v.z() + kAbove);
  std::vector<std::array<Vector3d, 3>> ground;
  for (std::uint32_t t = 0; t < terrain.size(); ++t)
    if (terrain.ground[t] != 0) {
      ground_triangles_.push_back(t);
      ground.push_back(corners_[t]);
    }
  if (ground.size() < terrain.size()) ground_.emplace(bounds_of(ground));
}

Nearest Surface::nearest(const Vector3d& p, Among among, double limit) const {
  Nearest best;
  const bool part = among == Among::kGround && ground_;
  const collision::WideTree& tree = part ? *ground_ : all_;
  const double reach = std::nextafter(limit, INFINITY);
  tree.nearest({p, p}, reach * reach, [&](std::uint32_t item) {
    const std::uint32_t t = part ? ground_triangles_[item] : item;
    const double off = terrain_->normals[t].dot(p - corners_[t][0]);  // of the plane: often enough to see that it is no nearer
    if (off * off >= best.distance * (1.0 - kSamePlane)) return best.distance;
    const Vector3d point = nearest_on_triangle(p, corners_[t][0], corners_[t][1], corners_[t][2]);
    const double squared = (point - p).squaredNorm();
    if (squared < best.distance) best = {static_cast<int>(t), point, squared};
    return squared;
  });
  best.distance = std::sqrt(best.distance);
  return best.distance <= limit ? best : Nearest{};
}

std::optional<Hit> Surface::ray(const Vector3d& origin, const Vector3d& direction, double length) const {
  const Ray ray(origin, direction);
  Hit hit{-1, origin, INFINITY};
  all_.first(origin, direction, std::nextafter(length, INFINITY), [&](std::uint32_t t) {
    const double here = ray.to(corners_[t]);
    if (here < hit.distance) hit = {static_cast<int>(t), origin + here * direction, here};
    return here;
  });
  if (hit.triangle < 0 || hit.distance > length) return std::nullopt;
  return hit;
}

// Along z: few triangles lie above one another, so all in the column are tried.
std::optional<Hit> Surface::plumb(const Vector3d& from, double towards) const {
  const Ray ray(from, towards * Vector3d::UnitZ());
  Hit hit{-1, from, INFINITY};
  Bounds column(from, from);
  (towards < 0.0 ? column.min() : column.max()).z() = towards * kFar;
  all_.visit(column, [&](std::uint32_t t) {
    const double here = ray.to(corners_[t]);
    if (here < hit.distance) hit = {static_cast<int>(t), from + Vector3d(0, 0, towards * here), here};
    return true;
  });
  if (hit.triangle < 0) return std::nullopt;
  return hit;
}

std::optional<Hit> Surface::beneath(const Vector3d& p) const {
  std::optional<Hit> hit = plumb(p + kOn * Vector3d::UnitZ(), -1.0);
  if (hit) hit->distance = std::max(0.0, hit->distance - kOn);
  return hit;
}

std::optional<double> Surface::height(double x, double y) const {
  const auto hit = plumb({x, y, top_}, -1.0);
  if (!hit) return std::nullopt;
  return hit->point.z();
}

bool Surface::under(const Vector3d& p) const {
  const auto hit = plumb(p + kOn * Vector3d::UnitZ(), 1.0);
  return hit && terrain_->normals[static_cast<std::size_t>(hit->triangle)].z() > 0.0;
}

double Surface::distance(const Capsule& capsule) const { return distance_to(corners_, all_, capsule); }
double Surface::distance(const Box& box) const { return distance_to(corners_, all_, box); }
bool Surface::nearer(const Capsule& capsule, double clearance) const { return nearer_to(corners_, all_, capsule, clearance); }
bool Surface::nearer(const Box& box, double clearance) const { return nearer_to(corners_, all_, box, clearance); }

std::vector<int> Surface::touching(const Bounds& query) const {
  std::vector<int> out;
  all_.visit(query, [&](std::uint32_t t) {
    if (query.intersects(collision::bounds_of(collision::Patch{corners_[t]}))) out.push_back(static_cast<int>(t));
    return true;
  });
  return out;
}

}  // namespace foothold::terrain

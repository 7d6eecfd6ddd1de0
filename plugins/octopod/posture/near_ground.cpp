// Planes first, triangles then.
#include "octopod/posture/near_ground.hpp"

namespace foothold::octopod {
namespace {

using collision::Box;
using collision::Capsule;

constexpr double kSamePlane = 1e-12;  // of normals and offsets: pieces of one triangle
constexpr double kTouch = 1e-6;       // m: a sole this near stands on a triangle
constexpr double kSole = 1e-3;        // m, the end of a foot that only touches
constexpr double kKeep = 1e-7;        // m, of the rest of a foot from what it does not stand on
constexpr double kHollow = 1e-9;      // m, a corner this far above another triangle's plane makes a hollow

}  // namespace

NearGround::NearGround(const terrain::Surface& surface, const collision::Bounds& bounds) : surface_(&surface) {
  const terrain::Terrain& terrain = surface.terrain();
  surface.visit(bounds, [&](std::uint32_t found) {
    if (triangles_ == kMost) return !(too_many_ = true);
    const int t = static_cast<int>(found);
    const Vector3d& normal = terrain.normals[found];
    const double offset = normal.dot(terrain.corner(t, 0));
    // Pieces of one triangle are neighbours in the tree: the last planes first. A plane that is kept twice does no harm.
    const std::size_t oldest = planes_ < kRecent ? 0 : planes_ - kRecent;
    std::size_t k = planes_;
    while (k > oldest && !(std::abs(plane_[k - 1].offset - offset) < kSamePlane &&
                           (plane_[k - 1].normal - normal).cwiseAbs().maxCoeff() < kSamePlane))
      --k;
    if (k == oldest) {
      if (planes_ == kMostPlanes) return !(too_many_ = true);
      plane_[planes_++] = {normal, offset};
      k = planes_;
    }
    triangle_[triangles_] = t;
    bounds_[triangles_] = collision::bounds_of(
        collision::Patch{std::array<Vector3d, 3>{terrain.corner(t, 0), terrain.corner(t, 1), terrain.corner(t, 2)}});
    plane_of_[triangles_++] = static_cast<std::uint8_t>(k - 1);
    return true;
  });
}

bool NearGround::above(std::span<const Kept> points) const {
  if (too_many_) return false;
  for (std::size_t k = 0; k < planes_; ++k)
    for (const Kept& each : points)
      if (plane_[k].normal.dot(each.point) - plane_[k].offset < each.keep) return false;
  return true;
}

template <class Visit>
bool NearGround::visit(const collision::Bounds& around, const std::array<bool, kMostPlanes>& planes, Visit&& visit) const {
  const terrain::Terrain& terrain = surface_->terrain();
  for (std::size_t i = 0; i < triangles_; ++i) {
    if (!planes[plane_of_[i]] || !around.intersects(bounds_[i])) continue;
    const int t = triangle_[i];
    const std::array<Vector3d, 3> corners{terrain.corner(t, 0), terrain.corner(t, 1), terrain.corner(t, 2)};
    if (!visit(corners, plane_[plane_of_[i]])) return false;
  }
  return true;
}

template <class Body, class Below>
bool NearGround::nearer_to(const Body& body, double clearance, Below&& below) const {
  if (too_many_) return surface_->nearer(body, clearance);
  std::array<bool, kMostPlanes> is_below;
  bool any = false;
  for (std::size_t k = 0; k < planes_; ++k) any |= is_below[k] = below(plane_[k]);
  if (!any) return false;
  return !visit(collision::grown(collision::bounds_of(body), clearance), is_below,
                [&](const auto& corners, const Plane&) { return !collision::nearer(body, collision::Patch{corners}, clearance); });
}

bool NearGround::foot_free(const Vector3d& sole, const Vector3d& ankle) const {
  const Vector3d from = sole + kSole * (ankle - sole).normalized();
  const collision::Capsule line{from, ankle, kKeep};
  const collision::Bounds around = collision::grown(collision::bounds_of(line), kSole);
  if (too_many_) {
    const NearGround nearer(*surface_, around);
    return !nearer.too_many_ && nearer.foot_free(sole, ankle);
  }
  std::array<bool, kMostPlanes> is_below;
  bool any = false;
  for (std::size_t k = 0; k < planes_; ++k)
    any |= is_below[k] = std::min(plane_[k].normal.dot(from), plane_[k].normal.dot(ankle)) - plane_[k].offset < kKeep;
  if (!any) return true;
  bool above_one = false, below_one = false, hollow = false;
  std::array<bool, kMostPlanes> all;
  all.fill(true);
  std::array<std::array<Vector3d, 3>, 16> under;
  std::array<Plane, 16> plane;
  std::size_t count = 0;
  const bool free = visit(around, all, [&](const auto& corners, const Plane& on) {
    if ((terrain::nearest_on_triangle(sole, corners[0], corners[1], corners[2]) - sole).norm() > kTouch)
      return !collision::nearer(line, collision::Patch{corners}, 0.0);
    if (count == under.size()) return false;
    (on.normal.dot(ankle - sole) > kKeep ? above_one : below_one) = true;
    under[count] = corners;
    plane[count++] = on;
    return true;
  });
  if (!free) return false;
  if (!below_one) return true;
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = 0; j < count; ++j)
      for (const Vector3d& corner : under[i]) hollow |= plane[j].normal.dot(corner) - plane[j].offset > kHollow;
  return above_one && !hollow;
}

bool NearGround::nearer(const Capsule& capsule, double clearance) const {
  const double keep = capsule.radius + clearance;
  return nearer_to(capsule, clearance, [&](const Plane& plane) {
    return std::min(plane.normal.dot(capsule.a), plane.normal.dot(capsule.b)) - plane.offset < keep;
  });
}

bool NearGround::nearer(const Box& box, double clearance) const {
  return nearer_to(box, clearance, [&](const Plane& plane) {
    const double half = (box.pose.linear().transpose() * plane.normal).cwiseAbs().dot(box.half);
    return plane.normal.dot(box.pose.translation()) - half - plane.offset < clearance;
  });
}

Bodies bodies_of(const Model& model, const std::array<Isometry3d, 2>& modules, const std::array<LegPoints, kLegs>& legs) {
  Bodies out;
  for (std::size_t m = 0; m < 2; ++m) {
    out.body[m] = {modules[m], model.body / 2};
    const double forth = m == 0 ? -1.0 : 1.0;
    const Vector3d& middle = modules[m].translation();
    const Vector3d x = modules[m].linear().col(0);
    out.neck[m] = {middle + forth * model.body.x() / 2 * x, middle + forth * model.arm() * x, model.neck_radius};
  }
  for (std::size_t i = 0; i < kLegs; ++i) {
    const LegPoints& at = legs[i];
    out.sole[i] = at.foot;
    out.femur[i] = {at.shoulder, at.knee, model.leg_radius};
    out.tibia[i] = {at.knee, at.foot + (at.knee - at.foot) * (model.foot / model.tibia), model.leg_radius};
  }
  return out;
}

collision::Bounds bounds_of(const Bodies& bodies) {
  collision::Bounds out;
  for (std::size_t m = 0; m < 2; ++m) out.extend(collision::bounds_of(bodies.body[m])).extend(collision::bounds_of(bodies.neck[m]));
  for (std::size_t i = 0; i < kLegs; ++i)
    out.extend(collision::bounds_of(bodies.femur[i])).extend(collision::bounds_of(bodies.tibia[i])).extend(bodies.sole[i]);
  return out;
}

std::optional<int> touching(const NearGround& ground, const Bodies& bodies, double clearance) {
  for (std::size_t m = 0; m < 2; ++m)
    if (ground.nearer(bodies.body[m], clearance) || ground.nearer(bodies.neck[m], clearance)) return -1;
  for (std::size_t i = 0; i < kLegs; ++i)
    if (ground.nearer(bodies.femur[i], clearance) || ground.nearer(bodies.tibia[i], clearance) ||
        !ground.foot_free(bodies.sole[i], bodies.tibia[i].b))
      return static_cast<int>(i);
  return std::nullopt;
}

}  // namespace foothold::octopod

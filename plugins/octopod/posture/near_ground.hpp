// The triangles around the robot, taken out of the tree once for the many bodies that are tested there.
//
// Most ground is flat or hollow as seen from a leg: what lies above the planes of all triangles around touches none, and neighbours
// share planes. Only bodies beneath some plane are compared with that plane's triangles one by one.
#pragma once

#include <array>
#include <span>

#include "octopod/model/body.hpp"
#include "terrain/surface.hpp"

namespace foothold::octopod {

// Holds for bodies inside the bounds that it was made for, less the clearance. On the stack, without allocation; borrows the
// surface. Where there are too many triangles the surface's own tree is asked.
class NearGround {
 public:
  NearGround(const terrain::Surface& surface, const collision::Bounds& bounds);

  // As of the surface: true if nearer than `clearance` (m, >= 0) to a triangle, or cut by one.
  bool nearer(const collision::Capsule& capsule, double clearance) const;
  bool nearer(const collision::Box& box, double clearance) const;
  // Whether all points are above all planes around, each by what it must keep, m. Then nothing between them, and nothing as thick
  // as that, touches the ground; if not, it may be free all the same.
  struct Kept {
    Vector3d point;
    double keep;
  };
  bool above(std::span<const Kept> points) const;

  // Whether the line from a sole on (or off) the ground up to its ankle comes from outside and cuts no other ground: of triangles
  // that meet under the sole the ankle is above all where they make a hollow, above one where they make a ridge.
  bool foot_free(const Vector3d& sole, const Vector3d& ankle) const;
  const terrain::Surface& surface() const { return *surface_; }

 private:
  static constexpr std::size_t kMost = 256, kMostPlanes = 128, kRecent = 8;
  struct Plane {
    Vector3d normal;
    double offset;
  };
  template <class Visit>
  bool visit(const collision::Bounds& around, const std::array<bool, kMostPlanes>& planes, Visit&& visit) const;
  template <class Body, class Below>
  bool nearer_to(const Body& body, double clearance, Below&& below) const;

  const terrain::Surface* surface_;
  std::size_t planes_ = 0, triangles_ = 0;
  bool too_many_ = false;  // then the tree is asked
  std::array<Plane, kMostPlanes> plane_;
  std::array<int, kMost> triangle_;
  std::array<collision::Bounds, kMost> bounds_;
  std::array<std::uint8_t, kMost> plane_of_;
};

// Bodies of the robot: a module's body and neck, a leg's femur and tibia, and where its foot ends.
struct Bodies {
  std::array<collision::Box, 2> body;
  std::array<collision::Capsule, 2> neck;
  std::array<collision::Capsule, kLegs> femur, tibia;  // the tibia down to the ankle
  std::array<Vector3d, kLegs> sole;
};
Bodies bodies_of(const Model& model, const std::array<Isometry3d, 2>& modules, const std::array<LegPoints, kLegs>& legs);
collision::Bounds bounds_of(const Bodies& bodies);

// The leg of which a part is nearer to the ground than `clearance` (m) or whose foot cuts it: 0 to 7; -1: a body or a neck; empty
// if none is.
std::optional<int> touching(const NearGround& ground, const Bodies& bodies, double clearance);

}  // namespace foothold::octopod

// How the octopod stands over a node of the terrain (paper, section 5.1).
#pragma once

#include <array>
#include <limits>
#include <string>

#include "octopod/model/body.hpp"

namespace foothold::terrain {
class CentroidTree;
class Surface;
}  // namespace foothold::terrain

namespace foothold::octopod {

// Where a foot stands: a point of the surface, the normal that faces up there, and the triangle.
struct Footing {
  Vector3d point = Vector3d::Zero();
  Vector3d normal = Vector3d::UnitZ();
  int triangle = -1;
};

// The robot with all eight feet on the surface.
struct Standing {
  Coordinates at;
  Isometry3d rear = Isometry3d::Identity();  // module B in the world, as `at` gives it
  std::array<Footing, kLegs> feet{};
  Vector3d centre_of_mass = Vector3d::Zero();  // m, world
  double residual = 0.0;                       // m, greatest distance of a foot from its footing
};

enum class Hindrance { kNone, kNoGround, kOutOfReach, kNotConverged, kCollision, kSelfContact };

// A standing robot, or why there is none: which leg, and the figure in a sentence made by reason().
struct Built {
  Standing standing;
  Hindrance hindrance = Hindrance::kNone;
  int leg = -1;         // of kNoGround, kOutOfReach, kCollision (-1: a body), kSelfContact (8: A's body)
  double figure = 0.0;  // m, such as how far out of reach
  int other = -1;       // of kSelfContact: what the leg is too near to: a leg, or 8, 9: the body of A, B
};
std::string reason(const Built& built);

// The paper tries four axes 45 degrees apart in the node's plane (ep). An axis has two ends, and module A can look to either:
// walking on, A and B must not change places, and a robot whose axis can turn by 135 degrees only could never turn round. So a
// state has one of eight headings, A's; heading k + 4 is heading k turned by half. The robot is alike at both ends, so both have
// the same feet, the same verdicts, and postures that follow from each other (turned()): four postures a node are made, not eight.
// Heading 0: world X projected into the node's plane (world Y where the normal lies within 26 degrees of world X); then
// counter-clockwise seen from outside.
inline constexpr int kAxes = 4;
inline constexpr int kOrientations = 8;
// The paper's ep as module A looks along it: a unit vector in the plane of the unit vector `normal`.
Vector3d axis_of(const Vector3d& normal, int orientation);

// The same standing robot with A and B exchanged: every foot stays, limb i becomes limb 7 - i. Its own inverse.
Built turned(const Model& model, const Built& built);

// Puts the robot over a node: C above it, bodies along the axis with the normals beneath, feet down to the surface, then bodies and
// legs brought together by Newton's method where a leg does not reach. Deterministic. `clearance` (m): bodies and legs (beyond
// their feet) keep so far from the surface, and legs (to their soles) and bodies so far from each other, and a millimetre more.
// `orientation`: 0 to 7. Any thread.
Built stand(const Model& model, const terrain::Surface& surface, const Vector3d& node, const Vector3d& normal, int orientation,
            double clearance);

// The paper's own way to the same: footholds by the centroids within 1.5 R of the shoulder (which may miss the nearest triangle),
// then Newton's method, least norm, on both bodies and all joints from the right angles on; kNotConverged where that fails. Legs
// may cross each other, as the paper does not look. `axis`: 0 to 3. Allocates; a hundred times slower. Any thread.
Built stand_paper(const Model& model, const terrain::Surface& surface, const terrain::CentroidTree& centroids, const Vector3d& node,
                  const Vector3d& normal, int axis, double clearance);

// The paper's q: difference of two standing postures, m: weighted change of the bodies' places (m), orientations (rad) and of the
// legs' joints (rad). A metric: so q never falls below any of its parts.
struct ChangeWeights {
  double place = 1.0;        // 1
  double orientation = 0.1;  // m/rad
  double joints = 0.01;      // m/rad
};
// Of changes that are `enough` or more it may tell anything from `enough` to the change: searches ask for far more than they use.
double change(const Standing& a, const Standing& b, const ChangeWeights& weights,
              double enough = std::numeric_limits<double>::infinity());

}  // namespace foothold::octopod

// What robots ask of a terrain: the nearest point, what lies beneath, whether a body is near or through it.
//
// A tree over the triangles themselves, so answers are exact (double precision), whatever the triangles' sizes. Any thread;
// immutable.
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "collision/distance.hpp"
#include "collision/wide_tree.hpp"
#include "terrain/terrain.hpp"

namespace foothold::terrain {

using collision::Box;
using collision::Capsule;

struct Nearest {
  int triangle = -1;                  // of several at the same distance (an edge, a corner) the lowest; -1: none within the limit
  Vector3d point = Vector3d::Zero();  // m, on the triangle
  double distance = std::numeric_limits<double>::infinity();  // m
};

struct Hit {
  int triangle = -1;
  Vector3d point = Vector3d::Zero();  // m
  double distance = 0.0;              // m, from the ray's origin
};

enum class Among : std::uint8_t { kGround, kAll };

class Surface {
 public:
  // Borrows the terrain, which must outlive it.
  explicit Surface(const Terrain& terrain);

  const Terrain& terrain() const { return *terrain_; }

  // Nearest point of the ground (or of all triangles) to `p`, not beyond `limit` (m).
  Nearest nearest(const Vector3d& p, Among among = Among::kGround, double limit = std::numeric_limits<double>::infinity()) const;

  // First triangle that the ray from `origin` along the unit vector `direction` meets within `length` (m), from either side.
  std::optional<Hit> ray(const Vector3d& origin, const Vector3d& direction,
                         double length = std::numeric_limits<double>::infinity()) const;
  // Straight down from `p` (m): the triangle beneath; none beside the terrain or below it.
  std::optional<Hit> beneath(const Vector3d& p) const;
  // z of the highest triangle at (x, y), m.
  std::optional<double> height(double x, double y) const;
  // Whether `p` is in the ground: the first triangle straight above it shows its inner side.
  bool under(const Vector3d& p) const;

  // Exact distances to all triangles (obstacles, too), 0 where the body touches or is cut by one; whether it is nearer than
  // `clearance` (m, >= 0), which is faster. The surface has no thickness: a body wholly under it is near nothing; ask under() for
  // one of its points.
  double distance(const Capsule& capsule) const;
  double distance(const Box& box) const;
  bool nearer(const Capsule& capsule, double clearance) const;
  bool nearer(const Box& box, double clearance) const;

  // Triangles whose bounds touch `query` (m, world axes), in no particular order.
  std::vector<int> touching(const collision::Bounds& query) const;
  // The same (and perhaps some within rounding) one by one, without a list: calls visit(triangle) (unsigned) and ends when it
  // returns false. Returns whether it ran to the end.
  template <class Visit>
  bool visit(const collision::Bounds& query, Visit&& visit) const {
    return all_.visit(query, std::forward<Visit>(visit));
  }

 private:
  std::optional<Hit> plumb(const Vector3d& from, double towards) const;

  const Terrain* terrain_;
  std::vector<std::array<Vector3d, 3>> corners_;  // by triangle, m
  collision::WideTree all_;
  std::optional<collision::WideTree> ground_;    // where not all is ground
  std::vector<std::uint32_t> ground_triangles_;  // of the items of that tree
  double top_;                                   // m, above all vertices
};

// Of the triangle's area; m. (Ericson 2005, section 5.1.5: by the regions of corners, sides and inside.)
Vector3d nearest_on_triangle(const Vector3d& p, const Vector3d& a, const Vector3d& b, const Vector3d& c);

}  // namespace foothold::terrain

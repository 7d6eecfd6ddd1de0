// Triangles to smaller ones.
#include <Eigen/Geometry>
#include <cmath>
#include <stdexcept>

#include "foothold/errors.hpp"
#include "terrain/adjacency.hpp"

namespace foothold::terrain {
namespace {

using Corners = std::array<int, 3>;

constexpr int kDeepest = 30;  // halvings: a kilometre to a thousandth of a millimetre

class Cutter {
 public:
  Cutter(const Terrain& whole, double bound, Split split, std::size_t most)
      : whole_(whole), bound_(bound), split_(split), most_(most) {
    out_.description = whole.description;
    out_.vertices = whole.vertices;
  }

  Terrain cut() && {
    if (split_ == Split::kLongestSide)
      by_rounds();
    else
      for (std::size_t t = 0; t < whole_.size(); ++t) cut(whole_.triangles[t], t);
    find_normals(out_);
    find_adjacent(out_, middles_);
    return std::move(out_);
  }

 private:
  const Vector3d& at(int vertex) const { return out_.vertices[static_cast<std::size_t>(vertex)]; }
  double squared(int a, int b) const { return (at(a) - at(b)).squaredNorm(); }
  double twice_area(const Corners& c) const { return (at(c[1]) - at(c[0])).cross(at(c[2]) - at(c[0])).norm(); }

  bool small(const Corners& c) const {
    const double sides = std::sqrt(squared(c[0], c[1]) * squared(c[1], c[2]) * squared(c[2], c[0]));
    return sides < bound_ * 2.0 * twice_area(c);
  }

  // The corner where the longest side begins; of sides of the same length the same one, whichever triangle asks.
  std::size_t longest(const Corners& c) const {
    std::size_t best = 0;
    for (std::size_t k = 1; k < 3; ++k) {
      const double here = squared(c[k], c[(k + 1) % 3]), there = squared(c[best], c[(best + 1) % 3]);
      if (here > there || (here == there && edge_key(c[k], c[(k + 1) % 3]) < edge_key(c[best], c[(best + 1) % 3]))) best = k;
    }
    return best;
  }

  int middle(int a, int b) {
    const auto [found, fresh] = middles_.try_emplace(edge_key(a, b), static_cast<int>(out_.vertices.size()));
    if (fresh) out_.vertices.push_back(0.5 * (at(a) + at(b)));
    return found->second;
  }

  void demand_room(std::size_t count) const {
    if (count >= most_)
      throw InvalidScene("triangles", "would be more than " + std::to_string(most_) + " after cutting to a circumradius of " +
                                          std::to_string(bound_) + " m");
  }

  void keep(const Corners& c, std::size_t origin) {
    demand_room(out_.size());
    out_.triangles.push_back(c);
    out_.ground.push_back(whole_.ground[origin]);
    out_.origins.push_back(whole_.origins[origin]);
  }

  void cut(const Corners& c, std::size_t origin, int depth = 0) {
    if (small(c)) return keep(c, origin);
    if (depth == kDeepest)
      throw InvalidScene("triangles[" + std::to_string(whole_.origins[origin]) + "]",
                         "is so thin a sliver that no cutting brings its circumradius below " + std::to_string(bound_) + " m");
    if (split_ == Split::kSlivers) {
      const std::size_t k = longest(c);
      const int a = c[k], b = c[(k + 1) % 3], apex = c[(k + 2) % 3];
      if (squared(a, b) > kSliver * twice_area(c)) {
        const int m = middle(a, b);
        cut({a, m, apex}, origin, depth + 1);
        cut({m, b, apex}, origin, depth + 1);
        return;
      }
    }
    const int ab = middle(c[0], c[1]), bc = middle(c[1], c[2]), ca = middle(c[2], c[0]);
    cut({c[0], ab, ca}, origin, depth + 1);
    cut({ab, c[1], bc}, origin, depth + 1);
    cut({ca, bc, c[2]}, origin, depth + 1);
    cut({ab, bc, ca}, origin, depth + 1);
  }

  // Each round marks the longest sides of what is too large, then those of whatever has a marked side, until nothing changes;
  // then every marked side is halved, so that no vertex hangs on a side.
  void by_rounds() {
    struct Piece {
      Corners corners;
      std::size_t origin;
    };
    std::vector<Piece> pieces;
    for (std::size_t t = 0; t < whole_.size(); ++t) pieces.push_back({whole_.triangles[t], t});
    for (;;) {
      const std::size_t before = out_.vertices.size();
      middles_.clear();
      const auto mark = [&](const Corners& c) {
        const std::size_t k = longest(c);
        middle(c[k], c[(k + 1) % 3]);
      };
      const auto marked = [&](int a, int b) { return middles_.contains(edge_key(a, b)); };
      for (const Piece& piece : pieces)
        if (!small(piece.corners)) mark(piece.corners);
      for (std::size_t last = before; last != out_.vertices.size();) {
        last = out_.vertices.size();
        for (const auto& [c, origin] : pieces)
          if (marked(c[0], c[1]) || marked(c[1], c[2]) || marked(c[2], c[0])) mark(c);
      }
      if (out_.vertices.size() == before) break;
      std::vector<Piece> finer;
      const auto halve = [&](const auto& self, const Corners& c, std::size_t origin) -> void {
        // A half's own longest side may be another one than what is marked on it: the marked side is halved.
        std::size_t k = longest(c);
        for (std::size_t tried = 0; tried < 3 && !marked(c[k], c[(k + 1) % 3]); ++tried) k = (k + 1) % 3;
        const int a = c[k], b = c[(k + 1) % 3], apex = c[(k + 2) % 3];
        if (!marked(a, b)) {
          demand_room(finer.size());
          finer.push_back({c, origin});
          return;
        }
        const int m = middle(a, b);
        self(self, {a, m, apex}, origin);
        self(self, {m, b, apex}, origin);
      };
      for (const auto& [c, origin] : pieces) halve(halve, c, origin);
      pieces = std::move(finer);
    }
    for (const auto& [c, origin] : pieces) keep(c, origin);
  }

  const Terrain& whole_;
  const double bound_;
  const Split split_;
  const std::size_t most_;
  Terrain out_;
  Midpoints middles_;
};

}  // namespace

Terrain subdivide(const Terrain& terrain, double bound, Split split, std::size_t most) {
  if (!(bound >= kLeastBound)) throw std::invalid_argument("triangles are cut to a circumradius of 1 mm at least");
  return Cutter(terrain, bound, split, most).cut();
}

}  // namespace foothold::terrain

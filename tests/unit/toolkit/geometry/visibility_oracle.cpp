#include "visibility_oracle.hpp"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Random.h>
#include <CGAL/random_polygon_2.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <variant>

namespace foothold::test {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Point = Kernel::Point_2;
using Segment = Kernel::Segment_2;
using Ring = CGAL::Polygon_2<Kernel>;
using geometry::Polygon;
using geometry::Vector2d;

struct Region {
  Ring outline;
  std::vector<Ring> holes;

  bool holds(const Point& point) const {
    if (outline.bounded_side(point) == CGAL::ON_UNBOUNDED_SIDE) return false;
    return std::none_of(holes.begin(), holes.end(),
                        [&](const Ring& hole) { return hole.bounded_side(point) == CGAL::ON_BOUNDED_SIDE; });
  }
  bool holds(const Segment& segment) const {
    std::vector<Point> cuts{segment.source(), segment.target()};
    const auto cut = [&](const Ring& ring) {
      for (auto edge = ring.edges_begin(); edge != ring.edges_end(); ++edge) {
        const auto common = CGAL::intersection(segment, *edge);
        if (!common) continue;
        if (const auto* point = boost::get<Point>(&*common)) {
          cuts.push_back(*point);
        } else {
          const auto& part = boost::get<Segment>(*common);
          cuts.push_back(part.source());
          cuts.push_back(part.target());
        }
      }
    };
    cut(outline);
    for (const Ring& hole : holes) cut(hole);
    std::sort(cuts.begin(), cuts.end());
    for (std::size_t k = 1; k < cuts.size(); ++k)
      if (cuts[k] != cuts[k - 1] && !holds(CGAL::midpoint(cuts[k - 1], cuts[k]))) return false;
    return true;
  }
};

Ring to_ring(const Polygon& polygon) {
  Ring out;
  for (const Vector2d& vertex : polygon) out.push_back(Point(vertex.x(), vertex.y()));
  return out;
}

Region to_region(const Polygon& outline, const std::vector<Polygon>& holes) {
  Region out{to_ring(outline), {}};
  for (const Polygon& hole : holes) out.holes.push_back(to_ring(hole));
  return out;
}

}  // namespace

bool exactly_inside(const Polygon& outline, const std::vector<Polygon>& holes, const Vector2d& point) {
  return to_region(outline, holes).holds(Point(point.x(), point.y()));
}

double exact_length(const Polygon& outline, const std::vector<Polygon>& holes, const Vector2d& from, const Vector2d& to) {
  const Region region = to_region(outline, holes);
  std::vector<Vector2d> nodes{from, to};
  nodes.insert(nodes.end(), outline.begin(), outline.end());
  for (const Polygon& hole : holes) nodes.insert(nodes.end(), hole.begin(), hole.end());
  std::vector<double> length(nodes.size(), std::numeric_limits<double>::infinity());
  std::vector<bool> done(nodes.size(), false);
  length[0] = 0.0;
  while (true) {
    std::size_t at = nodes.size();
    for (std::size_t k = 0; k < nodes.size(); ++k)
      if (!done[k] && (at == nodes.size() || length[k] < length[at])) at = k;
    if (at == 1 || at == nodes.size() || !std::isfinite(length[at])) return length[1];
    done[at] = true;
    for (std::size_t k = 1; k < nodes.size(); ++k) {
      const double through = length[at] + (nodes[k] - nodes[at]).norm();
      if (done[k] || through >= length[k]) continue;
      const Point a(nodes[at].x(), nodes[at].y()), b(nodes[k].x(), nodes[k].y());
      if (a == b || region.holds(Segment(a, b))) length[k] = through;
    }
  }
}

Polygon random_polygon(std::uint32_t seed, std::size_t vertices) {
  std::mt19937 random(seed);
  std::set<std::pair<int, int>> places;
  while (places.size() < vertices) places.emplace(static_cast<int>(random() % 1024), static_cast<int>(random() % 1024));
  std::vector<Point> points;
  for (const auto& [x, y] : places) points.emplace_back(x, y);
  // CGAL asks its own generator for a starting order: `points` comes in random order, and that one is asked for nothing else.
  std::shuffle(points.begin(), points.end(), random);
  Ring ring;
  CGAL::random_polygon_2(points.size(), std::back_inserter(ring), points.begin());
  if (ring.is_clockwise_oriented()) ring.reverse_orientation();
  Polygon out;
  for (const Point& point : ring.container())
    out.push_back(Vector2d(CGAL::to_double(point.x()), CGAL::to_double(point.y())) / 1024.0);
  return out;
}

}  // namespace foothold::test

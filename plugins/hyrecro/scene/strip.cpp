// Sliding rectangles.
#include "hyrecro/scene/strip.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/region.hpp"

namespace foothold::hyrecro {
namespace {

using geometry::Vector2d;
constexpr double kEdge = 1e-9;  // m: what counts as on the edge

// Each edge that enters the open strip forbids the middles from which the rectangle would meet it.
void add_forbidden(const geometry::Polygon& ring, const Slider& slider, std::vector<Stretch>& forbidden) {
  const Vector2d across(-slider.along.y(), slider.along.x());
  const double low = slider.low + kEdge, high = slider.high - kEdge;
  const auto local = [&](const Vector2d& v) {
    return Vector2d((v - slider.origin).dot(slider.along), (v - slider.origin).dot(across));
  };
  Vector2d a = local(ring.back());
  for (const Vector2d& vertex : ring) {
    const Vector2d b = local(vertex);
    if (std::min(a.y(), b.y()) < high && std::max(a.y(), b.y()) > low) {
      const auto at = [&](double s) { return a.x() + (b.x() - a.x()) * std::clamp((s - a.y()) / (b.y() - a.y()), 0.0, 1.0); };
      const double t0 = a.y() == b.y() ? a.x() : at(low), t1 = a.y() == b.y() ? b.x() : at(high);
      forbidden.push_back({std::min(t0, t1) - slider.half, std::max(t0, t1) + slider.half});
    }
    a = b;
  }
}

}  // namespace

std::vector<Stretch> free_stretches(const truss::Face& face, const Slider& slider) {
  std::vector<Stretch> forbidden;
  forbidden.reserve(8);
  add_forbidden(face.outline, slider, forbidden);
  for (const geometry::Polygon& hole : face.holes) add_forbidden(hole, slider, forbidden);
  std::sort(forbidden.begin(), forbidden.end(), [](const Stretch& a, const Stretch& b) { return a.begin < b.begin; });
  std::vector<Stretch> free;
  if (forbidden.empty()) return free;
  const Vector2d across(-slider.along.y(), slider.along.x());
  double end = forbidden.front().end;
  for (const Stretch& next : forbidden) {
    // Beyond the first and the last edge there is no face.
    if (next.begin > end - 2.0 * kEdge) {
      Stretch gap{end, next.begin};
      if (gap.end < gap.begin) gap.begin = gap.end = 0.5 * (gap.begin + gap.end);
      const double middle = 0.5 * (gap.begin + gap.end);
      const Vector2d centre = slider.origin + middle * slider.along + 0.5 * (slider.low + slider.high) * across;
      if (geometry::contains(geometry::Region{face.outline, face.holes}, centre)) free.push_back(gap);
    }
    end = std::max(end, next.end);
  }
  return free;
}

}  // namespace foothold::hyrecro

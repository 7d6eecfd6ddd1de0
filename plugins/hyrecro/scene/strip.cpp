// Sliding rectangles.
#include "hyrecro/scene/strip.hpp"

#include <algorithm>
#include <cmath>

namespace foothold::hyrecro {
namespace {

using geometry::Vector2d;
constexpr double kEdge = 1e-9;  // m: what counts as on the edge

}  // namespace

std::vector<Stretch> free_stretches(const FaceEdges& edges, const Slider& slider, const Stretch& window) {
  std::vector<Stretch> free;
  if (window.begin > window.end) return free;
  const Vector2d across(-slider.along.y(), slider.along.x());
  const double low = slider.low + kEdge, high = slider.high - kEdge;
  Eigen::AlignedBox2d swept;
  for (const double t : {window.begin - slider.half, window.end + slider.half})
    for (const double s : {slider.low, slider.high}) swept.extend(Vector2d(slider.origin + t * slider.along + s * across));
  if (!swept.intersects(edges.bounds())) return free;

  // Each edge that enters the open strip forbids the middles from which the rectangle would meet it.
  std::vector<Stretch> forbidden;
  edges.visit(swept.min().x(), swept.max().x(), [&](const FaceEdges::Edge& edge) {
    const Vector2d p = edge.a - slider.origin, q = edge.b - slider.origin;
    const Vector2d a(p.dot(slider.along), p.dot(across)), b(q.dot(slider.along), q.dot(across));
    if (std::min(a.y(), b.y()) >= high || std::max(a.y(), b.y()) <= low) return;
    const auto at = [&](double s) { return a.x() + (b.x() - a.x()) * std::clamp((s - a.y()) / (b.y() - a.y()), 0.0, 1.0); };
    const double t0 = a.y() == b.y() ? a.x() : at(low), t1 = a.y() == b.y() ? b.x() : at(high);
    const Stretch met{std::min(t0, t1) - slider.half, std::max(t0, t1) + slider.half};
    if (met.end > window.begin && met.begin < window.end) forbidden.push_back(met);
  });
  std::sort(forbidden.begin(), forbidden.end(), [](const Stretch& a, const Stretch& b) { return a.begin < b.begin; });

  double end = window.begin;
  const auto add_gap = [&](double until) {
    if (until < end - 2.0 * kEdge) return;
    Stretch gap{end, until};
    if (gap.end < gap.begin) gap.begin = gap.end = 0.5 * (gap.begin + gap.end);
    const double middle = 0.5 * (gap.begin + gap.end);
    if (edges.contains(slider.origin + middle * slider.along + 0.5 * (slider.low + slider.high) * across)) free.push_back(gap);
  };
  for (const Stretch& next : forbidden) {
    add_gap(next.begin);
    end = std::max(end, next.end);
  }
  add_gap(window.end);
  return free;
}

}  // namespace foothold::hyrecro

// Grid, rulers, scale bar and axes of one view.
#include "furniture.hpp"

#include <algorithm>
#include <cmath>

namespace foothold::drawing {
namespace {

constexpr double kGridStep = 60.0;    // px at least
constexpr double kScaleBar = 90.0;    // px at least
constexpr double kAxesLength = 30.0;  // px

double grid_step(const Panel& panel) { return round_length(kGridStep / panel.projection.scale); }

// Multiples of `step` in [low, high]. A step that is lost in the coordinates' rounding gives none.
std::vector<double> multiples(double step, double low, double high) {
  std::vector<double> found;
  const double first = std::ceil(low / step - 1e-9);
  constexpr double kMost = 400.0;
  if (!(first + 1.0 > first) || high / step - first > kMost) return found;
  for (double k = first; k * step <= high + 1e-9 * step; k += 1.0) found.push_back(k * step);
  return found;
}

// The world's coordinates at the borders of a view from above.
struct Sides {
  double left, right, bottom, top;
};
Sides sides_of(const Panel& panel) {
  const Projection& p = panel.projection;
  return {p.centre.x() + (panel.area.left - p.middle.x()) / p.scale, p.centre.x() + (panel.area.right() - p.middle.x()) / p.scale,
          p.centre.y() - (panel.area.bottom() - p.middle.y()) / p.scale, p.centre.y() - (panel.area.top - p.middle.y()) / p.scale};
}

void draw_axes(Svg& svg, const Panel& panel) {
  static constexpr const char* kLines[3] = {"ax", "ay", "az"};
  static constexpr const char* kTexts[3] = {"tx b l", "ty b l", "tz b l"};
  static constexpr const char* kNames[3] = {"X", "Y", "Z"};
  const Camera& camera = panel.projection.camera;
  const Vector3d origin(panel.area.left + 34.0, panel.area.bottom() - 30.0, 0.0);
  for (int axis = 0; axis < 3; ++axis) {
    const Vector3d way(camera.right[axis], -camera.up[axis], 0.0);
    if (way.norm() < 0.05) {
      svg.circle(kLines[axis], origin, 3.0);
      svg.text(kTexts[axis], origin.x() - 14.0, origin.y() + 12.0, kNames[axis]);
      continue;
    }
    const Vector3d tip = origin + way * kAxesLength;
    const Vector3d letter = origin + way * (kAxesLength + 9.0 / way.norm());
    svg.line(kLines[axis], origin, tip);
    svg.text(kTexts[axis], letter.x(), letter.y() + 4.0, kNames[axis], "middle");
  }
}

void draw_scale_bar(Svg& svg, const Panel& panel, LengthUnit unit) {
  const double length = round_length(kScaleBar / panel.projection.scale);
  const double pixels = length * panel.projection.scale;
  const double right = panel.area.right() - 14.0, y = panel.area.bottom() - 14.0;
  const Points bar{{right - pixels, y - 5.0, 0.0}, {right - pixels, y, 0.0}, {right, y, 0.0}, {right, y - 5.0, 0.0}};
  svg.path("halo", open_path(bar));
  svg.path("il", open_path(bar));
  svg.text("i l", right - pixels / 2.0, y - 6.0, readable(length * unit.per_metre) + " " + unit.name, "middle");
}

void draw_coordinates(Svg& svg, const Panel& panel, LengthUnit unit) {
  const Projection& p = panel.projection;
  const Sides sides = sides_of(panel);
  const double step = grid_step(panel);
  // Of a plan far from the origin the last digits count: more than readable() gives.
  const auto words = [&](double value) { return compact(value * unit.per_metre); };
  for (const double x : multiples(step, sides.left, sides.right)) {
    const double at = p.middle.x() + (x - p.centre.x()) * p.scale;
    svg.line("ql", {at, panel.area.bottom(), 0.0}, {at, panel.area.bottom() + 4.0, 0.0});
    svg.text("q l", at, panel.area.bottom() + 16.0, words(x), "middle");
  }
  for (const double y : multiples(step, sides.bottom, sides.top)) {
    const double at = p.middle.y() - (y - p.centre.y()) * p.scale;
    svg.line("ql", {panel.area.left - 4.0, at, 0.0}, {panel.area.left, at, 0.0});
    svg.text("q l", panel.area.left - 7.0, at + 4.0, words(y), "end");
  }
}

}  // namespace

double round_length(double least) {
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0, 10.0})
    if (factor * power >= least * (1.0 - 1e-12)) return factor * power;
  return 10.0 * power;
}

LengthUnit unit_for(double reach) { return reach < 1.0 ? LengthUnit{"mm", 1000.0} : LengthUnit{"m", 1.0}; }

void draw_grid(Svg& svg, const Panel& panel, const WorldBox& box) {
  const double step = grid_step(panel);
  std::string lines;
  if (panel.above) {
    const Projection& p = panel.projection;
    const Sides sides = sides_of(panel);
    for (const double x : multiples(step, sides.left, sides.right)) {
      const double at = p.middle.x() + (x - p.centre.x()) * p.scale;
      lines += open_path({{at, panel.area.top, 0.0}, {at, panel.area.bottom(), 0.0}});
    }
    for (const double y : multiples(step, sides.bottom, sides.top)) {
      const double at = p.middle.y() - (y - p.centre.y()) * p.scale;
      lines += open_path({{panel.area.left, at, 0.0}, {panel.area.right(), at, 0.0}});
    }
  } else if (panel.projection.camera.towards.z() > 0.05) {
    const Vector3d low = (box.low / step).array().floor() * step, high = (box.high / step).array().ceil() * step;
    const double z = box.low.z();
    const auto add = [&](const Vector3d& a, const Vector3d& b) { lines += open_path({panel.projection(a), panel.projection(b)}); };
    for (const double x : multiples(step, low.x(), high.x())) add({x, low.y(), z}, {x, high.y(), z});
    for (const double y : multiples(step, low.y(), high.y())) add({low.x(), y, z}, {high.x(), y, z});
  }
  if (!lines.empty()) svg.path("g", lines);
}

void draw_panel_frame(Svg& svg, const Panel& panel, LengthUnit unit, bool cut_off) {
  const Rectangle& area = panel.area;
  svg.path("ql", closed_path({{area.left, area.top, 0.0},
                              {area.right(), area.top, 0.0},
                              {area.right(), area.bottom(), 0.0},
                              {area.left, area.bottom(), 0.0}}));
  svg.text("i b c", area.left, area.top - 7.0, panel.caption + (cut_off ? "; the scene goes on beyond the border" : ""));
  if (panel.above) {
    draw_coordinates(svg, panel, unit);
    svg.text("q l", area.right(), area.top - 7.0, std::string("X to the right, Y up, in ") + unit.name, "end");
  }
  draw_axes(svg, panel);
  draw_scale_bar(svg, panel, unit);
}

}  // namespace foothold::drawing

// The whole picture: what is in it, where the views go, and their parts in turn.
#include "foothold/drawing/draw.hpp"

#include <algorithm>
#include <cmath>

#include "furniture.hpp"
#include "legend.hpp"
#include "style.hpp"

namespace foothold::drawing {
namespace {

constexpr double kMargin = 16.0;        // px, round the picture and between the views
constexpr double kRulerWidth = 46.0;    // px, left of the view from above
constexpr double kRulerHeight = 22.0;   // px, under the views
constexpr double kCaption = 24.0;       // px, over the views
constexpr double kTitleLine = 18.0;     // px
constexpr double kHeadline = 24.0;      // px
constexpr double kLarge = 17.0;         // px, the headline's font
constexpr double kSmall = 12.0;         // px, the other lines
constexpr std::size_t kMostLines = 3;   // of the picture, for each line of the title
constexpr double kInside = 30.0;        // px, round the content of a view
constexpr double kInsideBottom = 56.0;  // px, where scale bar and axes are
constexpr double kSinglePoint = 1.0;    // m, shown round a plan that has no width

void check(const DrawOptions& options) {
  const auto range = [](const char* name, double value, double low, double high) {
    if (value >= low && value <= high) return;
    throw InvalidDrawing(std::string("options.") + name,
                         "must be " + readable(low) + " to " + readable(high) + ", is " + readable(value));
  };
  constexpr double kLeast = 300.0, kMost = 20000.0;
  range("width", options.width, kLeast, kMost);
  if (options.height != 0.0) range("height", options.height, kLeast, kMost);
  range("azimuth", options.azimuth, -360.0, 360.0);
  range("elevation", options.elevation, -90.0, 90.0);
  if (options.first_step && options.last_step && *options.first_step > *options.last_step)
    throw InvalidDrawing("options.last_step", "must not be before first_step " + std::to_string(*options.first_step) + ", is " +
                                                  std::to_string(*options.last_step));
}

// World points that bound on a camera's picture what must be in it.
Points content(const Plan& plan, const Camera& camera, Frame frame) {
  Points points = base_way(plan);
  const auto add_body = [&](const Body& body) {
    const Points more = bounding_points(body, camera);
    points.insert(points.end(), more.begin(), more.end());
  };
  const auto add_contacts = [&](const std::vector<Foothold>& contacts) {
    for (const Foothold& contact : contacts) points.push_back(contact.frame.translation());
  };
  for (const Stance& stance : plan.stances) {
    std::for_each(stance.bodies.begin(), stance.bodies.end(), add_body);
    add_contacts(stance.placed);
    add_contacts(stance.holding);
  }
  for (const Mark* mark : {&plan.start, &plan.goal}) {
    add_contacts(mark->contacts);
    if (mark->base) points.push_back(*mark->base);
  }
  if (frame == Frame::kScene || points.empty()) std::for_each(plan.scene.begin(), plan.scene.end(), add_body);
  return points;
}

WorldBox world_box(const Points& points) {
  WorldBox box{points[0], points[0]};
  for (const Vector3d& p : points) box = {box.low.cwiseMin(p), box.high.cwiseMax(p)};
  return box;
}

struct Layout {
  std::vector<Panel> panels;
  std::vector<WorldBox> boxes;  // of each panel's content
  double legend_top = 0.0;
  double height = 0.0;
};

// The views side by side, each as large as it fits. A given height bounds the views; else they are as high as their content needs,
// within reason.
Layout lay_out(const Plan& plan, const DrawOptions& options, double title_height, double legend_height) {
  struct View {
    Camera camera;
    std::string caption;
    bool above;
    Reach reach;
  };
  std::vector<View> views;
  Layout layout;
  const auto add = [&](const Camera& camera, std::string caption, bool above) {
    const Points points = content(plan, camera, options.frame);
    views.push_back({camera, std::move(caption), above, reach(camera, points)});
    layout.boxes.push_back(world_box(points));
  };
  if (options.views != Views::kOblique) add(camera_above(), "from above", true);
  if (options.views != Views::kAbove)
    add(camera_oblique(options.azimuth, options.elevation),
        "oblique, seen from azimuth " + compact(options.azimuth) + "\xC2\xB0, elevation " + compact(options.elevation) + "\xC2\xB0",
        false);

  // The views share the width as their contents need it, neither less than 0.35 of it.
  const double rulers = options.views == Views::kOblique ? 0.0 : kRulerWidth;
  const double width = options.width - kMargin * static_cast<double>(views.size() + 1) - rulers;
  double sum = 0.0;
  for (const View& view : views) sum += view.reach.width;
  const double others = kInside + kInsideBottom;
  std::vector<double> widths, scales;
  double content_height = 0.0;
  for (const View& view : views) {
    widths.push_back(views.size() == 1 ? width : width * std::clamp(sum > 0.0 ? view.reach.width / sum : 0.5, 0.35, 0.65));
    const double reach = view.reach.width > 0.0 || view.reach.height > 0.0 ? view.reach.width : kSinglePoint;
    scales.push_back((widths.back() - 2.0 * kInside) / reach);  // infinite for an upright line
    if (view.reach.height > 0.0) content_height = std::max(content_height, view.reach.height * scales.back());
  }
  const double outer = title_height + kCaption + kRulerHeight + legend_height + kMargin;
  constexpr double kLowest = 0.25, kHighest = 0.75;  // of the picture's width
  const double wanted = options.height > 0.0
                            ? options.height - outer
                            : std::clamp(content_height + others, kLowest * options.width, kHighest * options.width);
  const double height = std::max(wanted, others + 40.0);

  const double top = title_height + kCaption;
  double left = kMargin + rulers;
  for (std::size_t i = 0; i < views.size(); ++i) {
    const View& view = views[i];
    double scale = scales[i];
    if (view.reach.height > 0.0) scale = std::min(scale, (height - others) / view.reach.height);
    Panel panel{view.caption, {}, {left, top, widths[i], height}, view.above};
    panel.projection = {view.camera, view.reach.centre, {left + widths[i] / 2.0, top + kInside + (height - others) / 2.0}, scale};
    layout.panels.push_back(panel);
    left += widths[i] + kMargin;
  }
  layout.legend_top = top + height + kRulerHeight;
  layout.height = std::ceil(layout.legend_top + legend_height + kMargin);
  return layout;
}

// Does the view leave out something of the scene?
bool cuts_off(const Plan& plan, const Panel& panel) {
  return std::any_of(plan.scene.begin(), plan.scene.end(), [&](const Body& body) {
    const Points seen = panel.projection(bounding_points(body, panel.projection.camera));
    return !std::all_of(seen.begin(), seen.end(), [&](const Vector3d& p) { return panel.area.holds(p); });
  });
}

std::size_t characters_in(double width, double font) { return static_cast<std::size_t>(width / text_width("m", font)); }

void draw_panel(Svg& svg, const Plan& plan, const Hues& hues, const std::vector<Crossing>& marks, const Panel& panel,
                const WorldBox& box, LengthUnit unit, std::size_t number) {
  const Rectangle& area = panel.area;
  const std::string name = panel.above ? "above" : "oblique";
  const std::string rectangle = "rect x='" + compact(area.left) + "' y='" + compact(area.top) + "' width='" + compact(area.width) +
                                "' height='" + compact(area.height) + "'";
  svg.raw("<clipPath id='c" + std::to_string(number) + "'><" + rectangle + "/></clipPath>\n");
  svg.open("g id='" + name + "' clip-path='url(#c" + std::to_string(number) + ")'");
  draw_grid(svg, panel, box);
  std::vector<SeenFace> faces = scene_faces(plan, panel.projection, area);
  const Occluders occluders(faces);
  const Canvas canvas{svg, panel.projection, area, occluders};
  draw_scene(canvas, plan, std::move(faces));
  draw_robot(canvas, plan, hues);
  draw_crossings(canvas, marks);
  draw_marks(canvas, plan);
  svg.close("g");
  draw_panel_frame(svg, panel, unit, cuts_off(plan, panel));
}

}  // namespace

std::string draw_svg(const Drawing& drawing, const DrawOptions& options) {
  check(options);
  const Plan plan = checked_plan(drawing, options);
  const Hues hues(plan);
  const std::vector<Crossing> marks = crossings(plan);
  const std::vector<std::string> title = title_lines(drawing, plan);

  const double inner = options.width - 2.0 * kMargin;
  std::vector<std::string> small_print;
  for (std::size_t i = 1; i < title.size(); ++i)
    for (std::string& line : wrapped(title[i], characters_in(inner, kSmall), kMostLines)) small_print.push_back(std::move(line));
  const double title_height = kMargin + kHeadline + kTitleLine * static_cast<double>(small_print.size());
  const double legend_height = draw_legend(nullptr, plan, hues, marks, kMargin, 0.0, inner);
  const Layout layout = lay_out(plan, options, title_height, legend_height);
  Svg svg;
  const std::string width = compact(options.width), height = compact(layout.height);
  svg.open("svg xmlns='http://www.w3.org/2000/svg' role='img' width='" + width + "' height='" + height + "' viewBox='0 0 " + width +
           " " + height + "'");
  svg.tooltip(title.front());
  std::string description;
  for (const std::string& line : title) description += escaped(line) + ".\n";
  svg.raw("<desc>" + description + "</desc>\n" + style_sheet());
  svg.element("rect class='p' width='" + width + "' height='" + height + "'");
  double y = kMargin + 14.0;
  svg.text("i t", kMargin, y, shortened(title.front(), characters_in(inner, kLarge)));
  y += kHeadline - 2.0;
  for (const std::string& line : small_print) {
    svg.text("q", kMargin, y, line);
    y += kTitleLine;
  }
  const WorldBox& box = layout.boxes.front();
  const LengthUnit unit = unit_for((box.high - box.low).maxCoeff());
  for (std::size_t i = 0; i < layout.panels.size(); ++i)
    draw_panel(svg, plan, hues, marks, layout.panels[i], layout.boxes[i], unit, i);
  draw_legend(&svg, plan, hues, marks, kMargin, layout.legend_top, inner);
  svg.close("svg");
  return svg.take();
}

}  // namespace foothold::drawing

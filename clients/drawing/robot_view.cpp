// The robot's bodies, faint at the first stance and strong at the last; what the scene hides of them as a dashed outline.
#include <algorithm>

#include "style.hpp"
#include "view.hpp"

namespace foothold::drawing {
namespace {

std::string path_of(const Region& region) {
  std::string data;
  for (const Points& ring : region) data += closed_path(ring);
  return data;
}

// The outline of a capsule or sphere of which nothing is hidden, in arcs.
std::string round_path(const Outline& seen) {
  const std::string radius = compact(seen.cap);
  const Vector2d along = (seen.to - seen.from).head<2>();
  const Vector2d way = along.norm() < 1e-6 ? Vector2d(1.0, 0.0) : Vector2d(along.normalized());
  const Vector2d side = Vector2d(way.y(), -way.x()) * seen.cap;
  const Vector2d from = seen.from.head<2>(), to = seen.to.head<2>();
  std::string data;
  const auto go = [&](const std::string& how, const Vector2d& at) {
    data.append(how).append(compact(at.x())).append(" ").append(compact(at.y()));
  };
  const std::string arc = std::string("A").append(radius).append(" ").append(radius).append(" 0 0 1 ");
  go("M", from + side);
  go("L", to + side);
  go(arc, to - side);
  go("L", from - side);
  go(arc, from + side);
  return data.append("Z");
}

void draw_body(const Canvas& canvas, const Body& body, int hue) {
  const std::vector<SeenFace> faces = seen_faces(body, canvas.projection, 0);
  std::vector<Points> hidden, visible;
  bool untouched = true;
  for (const SeenFace& face : faces) {
    const SplitRegion parts = canvas.occluders.split(face.points);
    untouched = untouched && parts.untouched;
    hidden.insert(hidden.end(), parts.hidden.begin(), parts.hidden.end());
    if (body.kind == msg::BOX) {
      if (!parts.visible.empty()) canvas.svg.path(robot_class(hue, face.shade), path_of(parts.visible));
    } else {
      visible.insert(visible.end(), parts.visible.begin(), parts.visible.end());
    }
  }
  if (body.kind != msg::BOX && !visible.empty()) {
    const bool round = body.kind != msg::POLYGON;
    const std::string data = untouched && round ? round_path(outline(body, canvas.projection))
                                                : path_of(untouched && visible.size() == 1 ? visible : unite(visible));
    canvas.svg.path(robot_class(hue, faces.front().shade), data);
  }
  for (const Points& piece : edge_on_pieces(body, canvas.projection))
    for (std::size_t i = 0; i < piece.size(); ++i) draw_line(canvas, hue_class(hue), piece[i], piece[(i + 1) % piece.size()]);
  if (!hidden.empty()) canvas.svg.path(std::string("h ").append(hue_class(hue)), path_of(unite(hidden)));
}

}  // namespace

Hues::Hues(const Plan& plan) {
  for (const Stance& stance : plan.stances)
    for (const Body& body : stance.bodies)
      if (std::find(names_.begin(), names_.end(), body.name) == names_.end()) {
        names_.push_back(body.name);
        if (names_.size() > static_cast<std::size_t>(kRobotHues)) {
          names_.clear();
          return;
        }
      }
}

int Hues::of(const std::string& body) const {
  const auto found = std::find(names_.begin(), names_.end(), body);
  return found == names_.end() ? 0 : static_cast<int>(found - names_.begin());
}

void draw_robot(const Canvas& canvas, const Plan& plan, const Hues& hues) {
  for (std::size_t i = 0; i < plan.stances.size(); ++i) {
    const Stance& stance = plan.stances[i];
    canvas.svg.open("g class='stance' opacity='" + compact(stance_opacity(i, plan.stances.size())) + "'");
    canvas.svg.tooltip("after step " + std::to_string(stance.index) + (stance.label.empty() ? "" : ": " + stance.label));
    std::vector<std::pair<double, const Body*>> order;
    for (const Body& body : stance.bodies) order.emplace_back(canvas.projection(middle_of(body)).z(), &body);
    std::stable_sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& [depth, body] : order) draw_body(canvas, *body, hues.of(body->name));
    if (stance.bodies.empty())
      for (const Foothold& contact : stance.holding)
        draw_line(canvas, "sk r0", canvas.projection(stance.base_way.back()), canvas.projection(contact.frame.translation()));
    canvas.svg.close("g");
  }
}

void draw_crossings(const Canvas& canvas, const std::vector<Crossing>& crossings) {
  // What one body cuts at one stance is one figure: the pieces of a mesh would each have their own outline.
  for (std::size_t i = 0; i < crossings.size();) {
    const Crossing& first = crossings[i];
    std::vector<Points> areas;
    std::string lines;
    for (; i < crossings.size() && crossings[i].step == first.step && crossings[i].body == first.body; ++i) {
      const Points region = canvas.projection(crossings[i].region);
      if (region.size() >= 3) areas.push_back(region);
      // Seen edge-on it has no area on the screen.
      if (region.size() < 3 || flat_area(region) < 1.0) lines += closed_path(region);
    }
    canvas.svg.open("g");
    canvas.svg.tooltip("after step " + std::to_string(first.step) + " " + first.body + " cuts " + first.piece);
    const std::string figure = path_of(unite(areas));
    canvas.svg.path("halo", figure + lines);
    if (!figure.empty()) canvas.svg.path("x", figure);
    if (!lines.empty()) {
      canvas.svg.path("xl", lines);
      canvas.svg.path("xm", lines);
    }
    canvas.svg.close("g");
  }
}

}  // namespace foothold::drawing

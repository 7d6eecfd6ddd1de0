// Lines, points and numbers over the robot: the base's way, start, goal, footholds.
#include <algorithm>

#include "labels.hpp"
#include "view.hpp"

namespace foothold::drawing {
namespace {

// px, a frame's axes that lie in the picture: told apart by length, not by colour alone
constexpr double kAxis[3] = {18.0, 11.0, 18.0};
constexpr double kNormal = 9.0;  // px, of a foothold among many
constexpr double kRing = 7.0;    // px, radius of start and goal marks

struct Named {
  Label label;
  bool hidden;
  std::string tooltip;
};

// Just off the surface, so that a foothold is not hidden by the very face that it stands on.
Vector3d lifted(const Canvas& canvas, const Isometry3d& frame) {
  return canvas.projection(frame * Vector3d(0.0, 0.0, 1.0 / canvas.projection.scale));
}

void draw_frame(const Canvas& canvas, const Isometry3d& frame) {
  static constexpr const char* kClasses[3] = {"ax", "ay", "az"};
  const double lift = 1.0 / canvas.projection.scale;
  // The axis that points away from the viewer first.
  std::vector<std::pair<double, int>> order;
  for (int axis = 0; axis < 3; ++axis) order.emplace_back(canvas.projection.camera.towards.dot(frame.linear().col(axis)), axis);
  std::sort(order.begin(), order.end());
  for (const auto& [depth, axis] : order) {
    const Vector3d off(0.0, 0.0, lift);
    Vector3d tip = off;
    tip[axis] += kAxis[axis] / canvas.projection.scale;
    draw_line(canvas, kClasses[axis], canvas.projection(frame * off), canvas.projection(frame * tip));
  }
}

// Where many feet are placed at once: the normal alone.
void draw_normal(const Canvas& canvas, const Isometry3d& frame) {
  const double pixel = 1.0 / canvas.projection.scale;
  draw_line(canvas, "az", canvas.projection(frame * Vector3d(0.0, 0.0, pixel)),
            canvas.projection(frame * Vector3d(0.0, 0.0, kNormal * pixel)));
}

std::string words_of(const Foothold& foothold) {
  return (foothold.limb.empty() ? "" : " " + foothold.limb) + (foothold.face.empty() ? "" : " on " + foothold.face);
}

void mark_placement(const Canvas& canvas, const Mark& mark, const std::string& name, std::vector<Named>& named) {
  const auto ring = [&](const Vector3d& at, bool hidden, const std::string& words) {
    const std::string dashes = hidden ? " d" : "";
    canvas.svg.circle(name + dashes, at, kRing);
    if (name == "G") canvas.svg.circle(name + dashes, at, kRing * 0.45);
    named.push_back({{name, at, {}}, hidden, words});
  };
  const std::string word = name == "S" ? "start" : "goal";
  for (const Foothold& contact : mark.contacts) {
    draw_frame(canvas, contact.frame);
    const Vector3d at = lifted(canvas, contact.frame);
    ring(at, canvas.occluders.hides(at), word + words_of(contact));
  }
  if (mark.base) ring(canvas.projection(*mark.base), canvas.occluders.hides(canvas.projection(*mark.base)), word + " of the base");
}

void draw_labels(const Canvas& canvas, std::vector<Named> named) {
  std::vector<Label> labels;
  for (const Named& one : named) labels.push_back(one.label);
  const LabelSize size = label_size(labels.size());
  place_labels(labels, size, canvas.area);
  for (const Label& label : labels) canvas.svg.line("kl", label.point, {label.at.x(), label.at.y(), 0.0});
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const Label& label = labels[i];
    const double width = label_width(label, size);
    canvas.svg.open("g class='label'");
    canvas.svg.tooltip(named[i].tooltip);
    canvas.svg.element(std::string("rect class='k") + (named[i].hidden ? " d" : "") + "' x='" +
                       compact(label.at.x() - width / 2.0) + "' y='" + compact(label.at.y() - size.height / 2.0) + "' width='" +
                       compact(width) + "' height='" + compact(size.height) + "' rx='" + compact(size.height / 2.0) + "'");
    canvas.svg.text(size.font < 10.0 ? "i o" : "i l", label.at.x(), label.at.y() + size.font * 0.36, label.text, "middle");
    canvas.svg.close("g");
  }
}

}  // namespace

void draw_line(const Canvas& canvas, const std::string& classes, const Vector3d& from, const Vector3d& to) {
  double done = 0.0;
  const auto at = [&](double t) { return Vector3d(from + (to - from) * t); };
  for (const auto& [begin, end] : canvas.occluders.hidden(from, to)) {
    if (begin > done) canvas.svg.line(classes, at(done), at(begin));
    canvas.svg.line(classes + " d", at(begin), at(end));
    done = end;
  }
  if (done < 1.0) canvas.svg.line(classes, at(done), to);
}

Points base_way(const Plan& plan) {
  Points way;
  // The start's base is the way's begin only if the first step of all is drawn.
  if (plan.start.base && !plan.stances.empty() && plan.stances.front().index == 0) way.push_back(*plan.start.base);
  for (const Stance& stance : plan.stances) way.insert(way.end(), stance.base_way.begin(), stance.base_way.end());
  return way;
}

std::vector<Foothold> held_before(const Plan& plan) {
  if (plan.stances.empty()) return {};
  std::vector<Foothold> held;
  const auto same = [](const Foothold& a, const Foothold& b) { return a.limb == b.limb && a.frame.isApprox(b.frame, 1e-9); };
  const auto among = [&](const Foothold& contact, const std::vector<Foothold>& all) {
    return std::any_of(all.begin(), all.end(), [&](const Foothold& other) { return same(contact, other); });
  };
  for (const Stance& stance : plan.stances)
    for (const Foothold& contact : stance.holding) {
      const bool placed =
          std::any_of(plan.stances.begin(), plan.stances.end(), [&](const Stance& one) { return among(contact, one.placed); });
      if (!placed && !among(contact, held) && !among(contact, plan.start.contacts)) held.push_back(contact);
    }
  return held;
}

void draw_marks(const Canvas& canvas, const Plan& plan) {
  Svg& svg = canvas.svg;
  const Points way = canvas.projection(base_way(plan));
  if (way.size() > 1) svg.path("halo", open_path(way));
  for (std::size_t i = 1; i < way.size(); ++i) draw_line(canvas, "w", way[i - 1], way[i]);
  for (const Stance& stance : plan.stances) svg.circle("wp", canvas.projection(stance.base_way.back()), 2.6);

  std::vector<Named> named;
  for (const Foothold& contact : held_before(plan)) draw_frame(canvas, contact.frame);
  for (const Stance& stance : plan.stances) {
    if (places_many(stance)) {
      for (const Foothold& placed : stance.placed) draw_normal(canvas, placed.frame);
      const Vector3d at = canvas.projection(stance.base_way.back());
      named.push_back({{std::to_string(stance.index), at, {}},
                       canvas.occluders.hides(at),
                       "step " + std::to_string(stance.index) + ": " + std::to_string(stance.placed.size()) + " feet"});
      continue;
    }
    for (const Foothold& placed : stance.placed) {
      draw_frame(canvas, placed.frame);
      const Vector3d at = lifted(canvas, placed.frame);
      named.push_back({{std::to_string(stance.index), at, {}},
                       canvas.occluders.hides(at),
                       "step " + std::to_string(stance.index) + ":" + words_of(placed)});
    }
  }
  mark_placement(canvas, plan.start, "S", named);
  mark_placement(canvas, plan.goal, "G", named);
  draw_labels(canvas, std::move(named));
}

}  // namespace foothold::drawing

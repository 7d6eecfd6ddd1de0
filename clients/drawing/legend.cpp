// Title and legend, from the messages alone.
#include "legend.hpp"

#include <algorithm>
#include <functional>
#include <set>

#include "foothold/msg/errors.hpp"
#include "style.hpp"

namespace foothold::drawing {
namespace {

constexpr double kLine = 22.0;    // px, height of a line of the legend
constexpr double kSwatch = 40.0;  // px
constexpr double kFont = 12.0;

struct Entry {
  std::string words;
  std::function<void(Svg&, double x, double y)> swatch;  // kSwatch wide from x on, centred on y
};

Vector3d at(double x, double y) { return {x, y, 0.0}; }

std::string steps_of(const Drawing& drawing, const Plan& plan) {
  const std::size_t all = drawing.steps.size(), drawn = plan.stances.size();
  std::string words = std::to_string(all) + (all == 1 ? " step" : " steps");
  if (drawing.summary && drawing.summary->steps() != all) words += " of " + std::to_string(drawing.summary->steps());
  if (drawn < all) {
    words += ", drawn: " + std::to_string(plan.stances.front().index);
    if (drawn > 1) words += " to " + std::to_string(plan.stances.back().index);
  }
  return words;
}

Entry frame_entry() {
  return {"foothold: X forward, Y (short), Z off the surface", [](Svg& svg, double x, double y) {
            svg.line("ax", at(x + 4, y + 4), at(x + 20, y + 4));
            svg.line("ay", at(x + 4, y + 4), at(x + 11, y - 2));
            svg.line("az", at(x + 4, y + 4), at(x + 4, y - 9));
          }};
}

Entry number_entry() {
  return {"the number of its step", [](Svg& svg, double x, double y) {
            svg.element("rect class='k' x='" + compact(x + 6) + "' y='" + compact(y - 7) + "' width='18' height='14' rx='7'");
            svg.text("i l", x + 15, y + 4, "3", "middle");
          }};
}

Entry body_entry(const std::string& words, int hue) {
  return {words, [hue](Svg& svg, double x, double y) {
            for (std::size_t k = 0; k < 3; ++k)
              svg.element("rect class='" + robot_class(hue, 5) + "' opacity='" + compact(stance_opacity(k, 3)) + "' x='" +
                          compact(x + static_cast<double>(k) * 11.0) + "' y='" + compact(y - 6) + "' width='10' height='12'");
          }};
}

Entry line_entry(const std::string& words, const std::string& classes) {
  return {words, [classes](Svg& svg, double x, double y) { svg.line(classes, at(x + 2, y), at(x + kSwatch - 10, y)); }};
}

Entry ring_entry(const std::string& words, const std::string& name) {
  return {words, [name](Svg& svg, double x, double y) {
            svg.circle(name, at(x + 14, y), 7.0);
            if (name == "G") svg.circle(name, at(x + 14, y), 3.0);
          }};
}

std::string steps_in(const std::vector<Crossing>& crossings) {
  std::set<std::uint32_t> steps;
  for (const Crossing& crossing : crossings) steps.insert(crossing.step);
  std::string words;
  constexpr std::size_t kMost = 12;
  std::size_t count = 0;
  for (const std::uint32_t step : steps) {
    if (count++ == kMost) return words + ", ...";
    words += (words.empty() ? "" : ", ") + std::to_string(step);
  }
  return words;
}

std::vector<Entry> entries(const Plan& plan, const Hues& hues, const std::vector<Crossing>& crossings) {
  std::vector<Entry> all;
  const bool footholds = std::any_of(plan.stances.begin(), plan.stances.end(), [](const Stance& s) { return !s.placed.empty(); });
  const bool bodies = std::any_of(plan.stances.begin(), plan.stances.end(), [](const Stance& s) { return !s.bodies.empty(); });
  if (!crossings.empty())
    all.push_back({"A BODY CUTS THE SCENE after step " + steps_in(crossings), [](Svg& svg, double x, double y) {
                     svg.path("x", closed_path({at(x + 2, y + 6), at(x + 8, y - 6), at(x + 28, y - 6), at(x + 22, y + 6)}));
                   }});
  const auto many = std::count_if(plan.stances.begin(), plan.stances.end(), places_many);
  if (many > 0)
    all.push_back({"foothold of a step that places many: Z off the surface",
                   [](Svg& svg, double x, double y) { svg.line("az", at(x + 10, y + 4), at(x + 10, y - 5)); }});
  const bool one_by_one = footholds && many < static_cast<std::ptrdiff_t>(plan.stances.size());
  if (one_by_one || !plan.start.contacts.empty() || !plan.goal.contacts.empty()) all.push_back(frame_entry());
  if (footholds) all.push_back(number_entry());
  if (bodies && hues.names().size() < 2) all.push_back(body_entry("the robot, first stance to last", 0));
  if (bodies && hues.names().size() >= 2)
    for (const std::string& name : hues.names())
      all.push_back(body_entry(shortened(name, 24) + ", first stance to last", hues.of(name)));
  if (!bodies && !plan.stances.empty()) all.push_back(line_entry("base to contacts (the steps bear no shapes)", "sk r0"));
  if (base_way(plan).size() > 1) all.push_back(line_entry("way of the base", "w"));
  if (!plan.start.empty()) all.push_back(ring_entry("S: start", "S"));
  if (!plan.goal.empty()) all.push_back(ring_entry("G: goal", "G"));
  if (!plan.scene.empty() && !plan.stances.empty()) all.push_back(line_entry("dashed: hidden by the scene", "il d"));
  return all;
}

}  // namespace

std::vector<std::string> title_lines(const Drawing& drawing, const Plan& plan) {
  const bool has = drawing.summary.has_value();
  const std::string robot = !drawing.robot.empty() ? drawing.robot : has ? drawing.summary->robot() : "";
  std::string headline = robot.empty() ? "plan" : robot;
  if (drawing.state != msg::UNKNOWN) headline += ": " + std::string(msg::state_name(drawing.state));
  std::vector<std::string> lines{headline};
  std::string plan_line = drawing.steps.empty() ? "no steps" : steps_of(drawing, plan);
  if (has) {
    const msg::Summary& s = *drawing.summary;
    const std::string unit = s.cost_unit().empty() || s.cost_unit() == "1" ? "" : " " + s.cost_unit();
    plan_line += "; cost " + readable(s.cost()) + unit + ", proved bound " + readable(s.lower_bound()) + unit;
    plan_line += s.optimal() ? ", optimal" : ", not proved optimal";
    if (!s.objective().empty()) plan_line += " (" + s.objective() + ")";
  } else if (!drawing.steps.empty()) {
    plan_line += "; cost so far " + readable(drawing.steps.back().cost());
  }
  lines.push_back(plan_line);
  if (has) {
    const msg::Summary& s = *drawing.summary;
    std::string made = "plugin " + s.plugin() + " " + s.plugin_version() + ", seed " + std::to_string(s.seed());
    if (!s.scene().empty()) made += ", scene " + s.scene() + " " + s.scene_revision().substr(0, 12);
    for (const msg::Parameter& parameter : s.parameters()) made += ", " + parameter.name() + "=" + parameter.value();
    lines.push_back(made);
  }
  if (drawing.error.code() != msg::NO_ERROR) lines.push_back(drawing.error.name() + ": " + drawing.error.message());
  return lines;
}

double draw_legend(Svg* svg, const Plan& plan, const Hues& hues, const std::vector<Crossing>& crossings, double left, double top,
                   double width) {
  double x = left, y = top + kLine / 2.0;
  for (const Entry& entry : entries(plan, hues, crossings)) {
    const double wide = kSwatch + text_width(entry.words, kFont) + 18.0;
    if (x > left && x + wide > left + width) {
      x = left;
      y += kLine;
    }
    if (svg != nullptr) {
      entry.swatch(*svg, x, y);
      svg->text("i", x + kSwatch, y + 4.0, entry.words);
    }
    x += wide;
  }
  return y + kLine / 2.0 - top;
}

}  // namespace foothold::drawing

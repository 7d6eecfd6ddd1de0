// Steps and summaries as text.
#include "report.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "foothold/msg/errors.hpp"
#include "terminal.hpp"

namespace foothold::cli {
namespace {

constexpr double kUpright = 0.05;  // deg of roll or pitch that still counts as upright

double degrees(double radians) { return radians * 180.0 / std::numbers::pi; }

std::string vector(const msg::Vector3& v) {
  const auto zero = [](double x) { return std::abs(x) < 0.5e-4 ? 0.0 : x; };  // no "-0.0000"
  return format("(%.4f, %.4f, %.4f) m", zero(v.x()), zero(v.y()), zero(v.z()));
}

// To a hundredth of a degree.
std::string angle(double value) { return number(std::round(value * 100.0) / 100.0); }

std::string list(const std::vector<double>& values) {
  std::string text;
  for (const double value : values) text += (text.empty() ? "" : ", ") + number(value);
  return "[" + text + "]";
}

std::string margin(const msg::Margin& m) {
  const std::string unit = m.unit().empty() || m.unit() == "1" ? "" : " " + printable(m.unit());
  return printable(m.name()) + " " + number(m.value()) + unit;
}

// How good the plan is, in one line.
std::string goodness(const msg::Summary& summary) {
  const std::string unit = summary.cost_unit().empty() || summary.cost_unit() == "1" ? "" : " " + printable(summary.cost_unit());
  std::string text = number(summary.cost()) + unit;
  if (summary.optimal()) {
    text += ", " + coloured(Colour::kGood, "proved least");
    if (!summary.objective().empty()) text += ": " + printable(summary.objective());
    return text;
  }
  text += "; proved: no plan costs less than " + number(summary.lower_bound()) + unit;
  if (!summary.objective().empty()) text += " (" + printable(summary.objective()) + ")";
  return text;
}

std::string scene(const msg::Summary& summary) {
  return summary.scene().empty() ? "none" : printable(summary.scene()) + " @ " + printable(summary.scene_revision());
}

}  // namespace

std::string describe(const msg::Pose& pose) {
  const msg::Quaternion& q = pose.orientation();
  const double w = q.w(), x = q.x(), y = q.y(), z = q.z();
  const double roll = degrees(std::atan2(2.0 * (w * x + y * z), 1.0 - 2.0 * (x * x + y * y)));
  const double pitch = degrees(std::asin(std::clamp(2.0 * (w * y - z * x), -1.0, 1.0)));
  const double yaw = degrees(std::atan2(2.0 * (w * z + x * y), 1.0 - 2.0 * (y * y + z * z)));
  if (std::abs(roll) < kUpright && std::abs(pitch) < kUpright) return vector(pose.position()) + ", " + angle(yaw) + " deg";
  return vector(pose.position()) + ", rpy " + angle(roll) + " " + angle(pitch) + " " + angle(yaw) + " deg";
}

void print_step(const msg::Step& step, double seconds, bool verbose, std::size_t& label_width) {
  std::string line = format("%4u  ", step.index());
  if (seconds >= 0.0) line += coloured(Colour::kDim, format("%8s", duration(seconds).c_str())) + "  ";
  std::string label = printable(step.label());
  label_width = std::max(label_width, label.size());
  label.resize(label_width, ' ');
  line += label;
  for (const msg::Contact& contact : step.placed()) line += "  " + printable(contact.limb()) + " at " + describe(contact.frame());
  if (step.placed().empty()) line += "  base " + describe(step.base());
  std::puts(line.c_str());
  if (!verbose) return;
  std::vector<std::vector<std::string>> rows;
  rows.push_back({"cost", number(step.cost())});
  rows.push_back({"base", describe(step.base())});
  for (const msg::Contact& contact : step.stance())
    rows.push_back({"holds", printable(contact.limb()) + " at " + describe(contact.frame()) +
                                 (contact.face().empty() ? "" : " on " + printable(contact.face()))});
  if (!step.joints().empty()) rows.push_back({"joints", list(step.joints())});
  for (const msg::Attribute& attribute : step.attributes())
    rows.push_back({printable(attribute.name()), printable(attribute.value())});
  for (const msg::Margin& m : step.margins()) rows.push_back({"margin", margin(m) + ", at least " + number(m.least())});
  print_table(rows, "        ");
}

void print_end(const msg::PlanEvent& event, const std::string& again) {
  const msg::Summary& summary = event.summary();
  const bool ran = !summary.plugin().empty();
  std::string times;
  if (ran)
    times = "  (queued " + duration(summary.queued()) + ", scene prepared " + duration(summary.prepared()) + ", planned " +
            duration(summary.planned()) + ")";
  std::printf("%s  %u step%s%s\n", coloured(event.state()).c_str(), event.steps(), event.steps() == 1 ? "" : "s", times.c_str());
  if (event.error().code() != msg::NO_ERROR) print(event.error(), stdout);
  if (!ran) return;
  std::vector<std::vector<std::string>> rows;
  if (event.state() == msg::SUCCEEDED || event.state() == msg::PARTIAL) rows.push_back({"cost", goodness(summary)});
  for (const msg::Margin& figure : summary.figures())
    rows.push_back({&figure == &summary.figures()[0] ? "figures" : "", margin(figure)});
  rows.push_back({"planner", printable(summary.plugin()) + " " + printable(summary.plugin_version()) + ", server " +
                                 printable(summary.server_version())});
  rows.push_back({"scene", scene(summary)});
  if (!again.empty()) rows.push_back({"again", again});
  print_table(rows, "  ");
}

std::string quoted(const std::string& word) {
  constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=./:@,%";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

}  // namespace foothold::cli

// foothold draw FILE|ID -o plan.svg: a plan as a picture, for any robot, from the messages alone.
#include "foothold/drawing/draw.hpp"

#include <algorithm>
#include <charconv>

#include "fetch.hpp"
#include "foothold/client/plan_file.hpp"
#include "foothold/client/whole_file.hpp"
#include "terminal.hpp"

namespace foothold::cli {
namespace {

client::PlanRecord plan_of(const Common& common, const std::string& source) {
  const auto id = msg::id_from_hex(source);
  if (!id) {
    try {
      return client::read_plan_file(source);
    } catch (const client::PlanFileError& error) {
      throw Complaint(Exit::kUsage, error.what(), "give a file of 'foothold plan -o', or a request's id");
    }
  }
  const Fetched fetched = fetch(connect(common), common, parse_id(source), true);
  if (fetched.event.state() == msg::UNKNOWN) throw unknown(*id);
  client::PlanRecord record = fetched.record;
  record.final_event = fetched.event;
  return record;
}

// "3-7", "3-", "-7" or "3".
void choose_steps(const std::string& text, drawing::DrawOptions& options) {
  const auto read = [&](std::string_view word) -> std::optional<std::uint32_t> {
    if (word.empty()) return std::nullopt;
    std::uint32_t index = 0;
    const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), index);
    if (fault != std::errc() || end != word.data() + word.size())
      throw Complaint(Exit::kUsage, "--steps " + text + ": expected FIRST-LAST, such as 3-7");
    return index;
  };
  const auto dash = text.find('-');
  options.first_step = read(std::string_view(text).substr(0, dash));
  options.last_step = dash == std::string::npos ? options.first_step : read(std::string_view(text).substr(dash + 1));
}

}  // namespace

Exit run_draw(const Common& common, const DrawOptions& options) {
  drawing::DrawOptions how;
  if (options.view == "above") how.views = drawing::Views::kAbove;
  if (options.view == "oblique") how.views = drawing::Views::kOblique;
  if (options.frame == "plan") how.frame = drawing::Frame::kPlan;
  if (!options.steps.empty()) choose_steps(options.steps, how);
  if (options.width) how.width = *options.width;
  if (options.azimuth) how.azimuth = *options.azimuth;
  if (options.elevation) how.elevation = *options.elevation;

  const client::PlanRecord plan = plan_of(common, options.source);
  drawing::Drawing what{.robot = plan.request.robot(),
                        .state = plan.final_event.state(),
                        .start = plan.request.start(),
                        .goal = plan.request.goal(),
                        .scene = plan.scene,
                        .steps = plan.steps,
                        .summary = std::nullopt,
                        .error = plan.final_event.error()};
  if (!plan.final_event.summary().plugin().empty()) what.summary = plan.final_event.summary();
  std::string picture;
  try {
    picture = drawing::draw_svg(what, how);
  } catch (const drawing::InvalidDrawing& error) {
    throw Complaint(Exit::kUsage, options.source + ": " + error.what());
  }
  try {
    client::write_whole_file(options.output, picture);
  } catch (const std::system_error& error) {
    throw Complaint(Exit::kOther, options.output + ": cannot be written: " + error.code().message());
  }
  const bool bodies = std::ranges::any_of(plan.steps, [](const msg::Step& step) { return !step.shapes().empty(); });
  std::printf("%s: %zu steps%s\n", options.output.c_str(), plan.steps.size(),
              bodies ? "" : "; without the robot's bodies: plan with --shapes to have them drawn");
  return Exit::kSucceeded;
}

}  // namespace foothold::cli

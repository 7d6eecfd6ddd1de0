// prepare, start, plan; and the one place where a plugin's exceptions end.
#include "worker/planning.hpp"

#include <chrono>
#include <new>

#include "foothold/msg/errors.hpp"
#include "text/text.hpp"
#include "worker/convert.hpp"
#include "worker/report.hpp"
#include "worker/stepper.hpp"

namespace foothold::server {
namespace {

// A planner's scenes can be large (grids, trees); a fleet works in few of them at a time.
constexpr std::size_t kScenesKept = 8;
// More than malloc keeps to itself when it is given back.
constexpr std::size_t kBallast = 4u << 20;

double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

msg::Error parameter_error(const ParameterFault& fault) {
  using Kind = ParameterFault::Kind;
  const std::uint16_t code = fault.kind == Kind::kUnknown      ? msg::UNKNOWN_PARAMETER
                             : fault.kind == Kind::kOutOfRange ? msg::PARAMETER_OUT_OF_RANGE
                                                               : msg::MALFORMED;
  return msg::make_error(code, fault.message, "parameters." + fault.name);
}

msg::Error request_error(const InvalidRequest& fault) {
  const std::string& field = fault.field();
  const std::uint16_t code = field.starts_with("goal")    ? msg::INVALID_GOAL
                             : field.starts_with("start") ? msg::INVALID_START
                                                          : msg::MALFORMED;
  return msg::make_error(code, cleaned(fault.what()), cleaned(field));
}

frame::Report stopped() {
  frame::Report report;
  report.state(msg::CANCELLED);
  return report;
}

}  // namespace

struct Planning::Attempt {
  const char* where = "prepare()";  // what the plugin is in
  std::chrono::steady_clock::time_point begin = std::chrono::steady_clock::now();
  double prepared = 0.0;
  SentSteps sent;
};

Planning::Planning(std::string robot, const PluginDescriptor& plugin, const RobotModel& model)
    : robot_(std::move(robot)),
      plugin_(plugin),
      planner_(plugin.create(model), plugin.destroy),
      scenes_(kScenesKept),
      ballast_(std::make_unique_for_overwrite<char[]>(kBallast)) {
  if (!planner_) throw std::runtime_error("it made no planner");
}

std::shared_ptr<const PreparedScene> Planning::prepared(const frame::Plan& plan, const ParsedParameters& parameters) {
  std::string key = plan.scene_revision() + '\n' + plan.scene_format() + '\n' + parameters.prepare_key;
  if (auto scene = scenes_.find(key)) return scene;
  const Scene scene{
      .name = plan.request().scene(), .revision = plan.scene_revision(), .format = plan.scene_format(), .path = plan.scene_path()};
  auto made = planner_->prepare(scene, parameters.values);
  if (!made) throw std::runtime_error("it returned no scene");
  scenes_.keep(std::move(key), made);
  return made;
}

frame::Report Planning::try_plan(std::uint64_t run, const frame::Plan& plan, const ParsedParameters& parameters,
                                 const std::stop_token& stop, Channel& channel, Attempt& attempt) {
  const auto scene = prepared(plan, parameters);
  attempt.prepared = seconds_since(attempt.begin);
  if (stop.stop_requested()) return stopped();

  const msg::PlanRequest& message = plan.request();
  if (message.shapes()) {
    attempt.where = "the prepared scene's shapes()";
    const auto shapes = scene->shapes();
    if (const auto fault = unsound_part(shapes)) throw std::runtime_error(*fault);
    frame::SceneShapes told;
    told.shapes(to_message(shapes));
    if (!channel.fits(told))
      return failed(msg::make_error(msg::OVERSIZE, "the scene's shapes are too large to be drawn", "shapes"));
    channel.send(frame::SCENE, run, told);
  }

  attempt.where = "start()";
  const Request request = to_request(message, plan.budget_left() - attempt.prepared);
  Posture start = planner_->start(request, parameters.values, *scene);
  attempt.where = "plan()";
  Stepper stepper(*planner_, RunFacts{run, message, parameters.values, *scene}, std::move(start), channel, stop, attempt.sent);
  const PlanReport report = planner_->plan(request, parameters.values, *scene, stepper);
  return to_report(report, stop.stop_requested());
}

void Planning::fill(msg::Summary& summary, const frame::Plan& plan, const ParsedParameters& parameters,
                    const Attempt& attempt) const {
  summary.steps(attempt.sent.count);
  summary.prepared(attempt.prepared);
  summary.planned(seconds_since(attempt.begin) - attempt.prepared);
  summary.plugin(plugin_.info.name);
  summary.plugin_version(plugin_.info.version);
  summary.robot(robot_);
  summary.scene(plan.request().scene());
  summary.scene_revision(plan.scene_revision());
  summary.parameters(parameters.texts);
  summary.seed(plan.request().seed());
}

frame::Report Planning::run(std::uint64_t run, const frame::Plan& plan, const std::stop_token& stop, Channel& channel) {
  Attempt attempt;
  ParsedParameters parameters;
  frame::Report report;
  try {
    parameters = parse_parameters(plugin_.info, plan.request().parameters());
    report = try_plan(run, plan, parameters, stop, channel, attempt);
  } catch (const ChannelClosed&) {
    throw;
  } catch (const ParameterFault& fault) {
    report = failed(parameter_error(fault));
  } catch (const InvalidRequest& fault) {
    report = failed(request_error(fault));
  } catch (const InvalidScene& fault) {
    report = failed(msg::make_error(msg::INVALID_SCENE, cleaned(fault.what()), cleaned(fault.field())));
  } catch (const std::bad_alloc&) {
    ballast_.reset();
    report = failed(msg::make_error(msg::OUT_OF_MEMORY, std::string("no memory left in ") + attempt.where));
  } catch (const std::exception& fault) {
    report = failed(msg::make_error(msg::PLUGIN_THREW, std::string(attempt.where) + " threw: " + cleaned(fault.what())));
  } catch (...) {
    report = failed(msg::make_error(msg::PLUGIN_THREW, std::string(attempt.where) + " threw something that is no std::exception"));
  }
  // A step that was refused is the cause of whatever plan() did afterwards.
  if (attempt.sent.refusal) {
    if (attempt.sent.refusal->code() == msg::OUT_OF_MEMORY) ballast_.reset();
    report = failed(*attempt.sent.refusal);
  }
  report.leave(report.reason().code() == msg::OUT_OF_MEMORY);
  fill(report.summary(), plan, parameters, attempt);
  return report;
}

}  // namespace foothold::server

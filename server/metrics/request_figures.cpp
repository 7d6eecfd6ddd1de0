// Counting requests.
#include "metrics/request_figures.hpp"

#include "foothold/msg/errors.hpp"

namespace foothold::server {

// Known robots stay known: a counter that is taken away and comes back from zero looks like a restart.
void RequestFigures::set_robots(const std::vector<std::string>& names) {
  for (const std::string& name : names) robots_.try_emplace(name);
}

RequestFigures::Robot& RequestFigures::of(const std::string& robot) {
  const auto known = robots_.find(robot);
  return known != robots_.end() ? known->second : robots_[""];
}

void RequestFigures::on_step(const msg::PlanRequest& request, std::uint32_t index, double since_last, double since_receipt) {
  Robot& robot = of(request.robot());
  ++robot.steps;
  robot.step.add(since_last);
  if (index == 0) robot.first_step.add(since_receipt);
}

void RequestFigures::on_ended(const EndedRequest& ended) {
  Robot& robot = of(ended.request.robot());
  ++robot.ended[std::string(msg::state_name(ended.event.state()))];
  if (ended.event.state() == msg::REJECTED) return;
  robot.wait.add(ended.waited);
  if (ended.ran) robot.plan.add(ended.planned);
}

void RequestFigures::write(Exposition& out) const {
  using Kind = Exposition::Kind;
  out.family("foothold_requests_total", Kind::kCounter, "Requests by the final state that they ended in.");
  for (const auto& [name, robot] : robots_) {
    for (std::uint32_t state = msg::SUCCEEDED; state <= msg::REJECTED; ++state) {
      const std::string_view state_name = msg::state_name(static_cast<msg::State>(state));
      const auto count = robot.ended.find(state_name);
      out.sample({{"robot", name}, {"state", state_name}}, count == robot.ended.end() ? std::uint64_t{0} : count->second);
    }
  }
  out.family("foothold_steps_total", Kind::kCounter, "Steps that were checked and sent.");
  for (const auto& [name, robot] : robots_) out.sample({{"robot", name}}, robot.steps);
  const auto histogram = [&](std::string_view name, std::string_view help, const Histogram Robot::*which) {
    out.family(name, Kind::kHistogram, help);
    for (const auto& [robot, figures] : robots_)
      if (!robot.empty()) out.sample({{"robot", robot}}, figures.*which);
  };
  histogram("foothold_wait_seconds", "From receipt to the start on a worker, or to the end if it never started.", &Robot::wait);
  histogram("foothold_plan_seconds", "From the start on a worker to the end.", &Robot::plan);
  histogram("foothold_step_seconds", "From the step before, or the start, to the step.", &Robot::step);
  histogram("foothold_first_step_seconds", "From receipt to the first step.", &Robot::first_step);
}

}  // namespace foothold::server

// The test's own world.
#include "fakes.hpp"

#include <gtest/gtest.h>

namespace foothold::server::testing {

msg::ParameterSpec parameter_spec(const std::string& name, msg::ParameterKind kind, const std::string& initial, double minimum,
                                  double maximum, std::vector<std::string> choices) {
  msg::ParameterSpec spec;
  spec.name(name);
  spec.kind(kind);
  spec.default_value(initial);
  spec.minimum(minimum);
  spec.maximum(maximum);
  spec.choices(std::move(choices));
  return spec;
}

msg::PlanRequest good_request(const std::string& name) {
  msg::PlanRequest request;
  request.id(msg::id_of(name));
  request.client(World::kClient);
  request.robot("walker");
  request.budget(10.0);
  request.seed(42);
  msg::Pose pose;
  pose.orientation().w(1.0);
  request.goal().base({pose});
  return request;
}

Bytes step_bytes(const Id& request, std::uint32_t index, const std::string& label) {
  msg::Step step;
  step.request(request);
  step.index(index);
  step.label(label);
  step.base().orientation().w(1.0);
  return msg::encode(step);
}

World::World() {
  options.server = msg::id_of("this server");
  options.version = "0.1.0";
  auto& walker = planners.add("walker", 2);
  walker.info.parameters({parameter_spec("cycles", msg::INTEGER, "7", 1, 30), parameter_spec("gain", msg::REAL, "0.5", 0, 1),
                          parameter_spec("careful", msg::FLAG, "true"),
                          parameter_spec("method", msg::CHOICE, "greedy", 0, 0, {"greedy", "optimal"}),
                          parameter_spec("note", msg::TEXT, "")});
  planners.add("climber", 1);
  shelf.scenes.push_back({"yard", std::string(64, 'a'), "yaml", "/state/a.yaml", 10, 1});
  shelf.scenes.push_back({"yard", std::string(64, 'b'), "yaml", "/state/b.yaml", 11, 2});
  restart();
}

void World::restart() {
  journal.crash();
  for (auto& [run, started] : planners.runs) {
    if (!started.ended) ++planners.robots.at(started.request.robot()).idle;
    started.ended = true;
  }
  jobs = std::make_unique<Jobs>(options,
                                Jobs::Ports{journal, planners, shelf, outbox, clock, watches, [this] { return others_serve; }},
                                [this](const std::string& text) { complaints.push_back(text); });
  jobs->recover();
  jobs->settle();
}

void World::submit(const msg::PlanRequest& request) {
  jobs->request(request);
  jobs->settle();
}

void World::cancel(const Id& id, const Id& client, const std::string& reason) {
  msg::CancelRequest cancel;
  cancel.id(id);
  cancel.client(client);
  cancel.reason(reason);
  jobs->cancel(cancel);
  jobs->settle();
}

void World::query(const Id& id, std::uint32_t from, const Id& client) {
  msg::StateQuery query;
  query.request(id);
  query.client(client);
  query.from_step(from);
  jobs->query(query);
  jobs->settle();
}

void World::step(const Id& id, std::uint32_t index, const std::string& label) {
  jobs->on_run_step(planners.run_of(id), index, step_bytes(id, index, label));
  jobs->settle();
}

void World::end(const Id& id, msg::State state, std::uint16_t code) {
  RunEnd end;
  end.state = state;
  if (code != 0) end.error = msg::make_error(code, "the planner's message", "goal.base");
  end.summary.cost(1.5);
  const Run run = planners.run_of(id);
  auto& started = planners.runs.at(run);
  started.ended = true;
  jobs->on_run_end(run, end);
  ++planners.robots.at(started.request.robot()).idle;
  jobs->on_slots_changed(started.request.robot());
  jobs->settle();
}

void World::lose(const Id& id, std::uint16_t code) {
  RunEnd end;
  end.kind = RunEnd::Kind::kLost;
  end.error = msg::make_error(code, "the worker died of SIGSEGV");
  const Run run = planners.run_of(id);
  auto& started = planners.runs.at(run);
  started.ended = true;
  jobs->on_run_end(run, end);
  ++planners.robots.at(started.request.robot()).idle;  // restarted at once
  jobs->on_slots_changed(started.request.robot());
  jobs->settle();
}

void World::wait(double seconds) {
  clock.advance(seconds);
  jobs->tick();
  jobs->settle();
}

void World::stop() {
  jobs->stop();
  jobs->settle();
}

std::vector<msg::PlanEvent> World::events(const Id& id, const Id& client) const {
  std::vector<msg::PlanEvent> found;
  for (const auto& message : outbox.messages)
    if (message.client == client && message.event && message.event->request() == id) found.push_back(*message.event);
  return found;
}

std::vector<std::uint32_t> World::steps(const Id& id, const Id& client) const {
  std::vector<std::uint32_t> found;
  for (const auto& message : outbox.messages) {
    if (message.client != client || message.event) continue;
    const auto step = msg::decode<msg::Step>(message.step);
    if (step && step->request() == id) found.push_back(step->index());
  }
  return found;
}

msg::PlanEvent World::last(const Id& id, const Id& client) const {
  const auto all = events(id, client);
  if (!all.empty()) return all.back();
  ADD_FAILURE() << "no event was told";
  return {};
}

}  // namespace foothold::server::testing

// See observer.hpp.
#include "observer.hpp"

#include <string_view>

#include "foothold/msg/cdr.hpp"
#include "foothold/msg/errors.hpp"

namespace foothold::faults {
namespace {

std::string describe(const Final& end) {
  return std::string(msg::state_name(static_cast<msg::State>(end.state))) + " (error " + std::to_string(end.code) + ", " +
         std::to_string(end.steps) + " steps)";
}

}  // namespace

Observer::Observer(const std::string& vendor, std::uint32_t domain)
    : bus_(transport::open_bus({.vendor = vendor, .domain = domain, .network_config = {}})) {
  event_reader_ = bus_->reader(transport::Topic::kEvent, "*", {.on_message = [this](std::span<const std::byte> octets) {
                                 if (const auto event = msg::decode<msg::PlanEvent>(octets)) take(*event);
                               }});
  step_reader_ = bus_->reader(transport::Topic::kStep, "*", {.on_message = [this](std::span<const std::byte> octets) {
                                if (const auto step = msg::decode<msg::Step>(octets)) take(*step, octets);
                              }});
}

Observer::~Observer() {
  // Before the rest: their callbacks use it.
  step_reader_.reset();
  event_reader_.reset();
}

void Observer::complain(const msg::Id& request, const std::string& what) {
  constexpr std::size_t kMost = 100;
  if (complaints_.size() < kMost) complaints_.push_back(msg::to_hex(request) + ": " + what);
}

void Observer::take(const msg::PlanEvent& event) {
  const std::lock_guard lock(mutex_);
  ++events_;
  if (event.state() == msg::UNKNOWN || event.request() == msg::kNoId) return;  // answers to cancels that came first
  Heard& heard = heard_[event.request()];
  if (event.state() == msg::RUNNING && !event.answer()) {
    if (heard.running) complain(event.request(), "RUNNING was told twice");
    // By its stamp: an answer in another client's partition may overtake it.
    if (heard.ended && event.stamp() > heard.ended_at)
      complain(event.request(), "began to run after it was " + describe(heard.end));
    heard.running = true;
  }
  if (!msg::is_final(event.state())) return;
  const Final end{event.state(), event.error().code(), event.steps()};
  if (heard.ended && heard.end != end) complain(event.request(), "ended as " + describe(heard.end) + " and as " + describe(end));
  if (!heard.ended) ++finals_;
  heard.ended = true;
  heard.ended_at = event.stamp();
  heard.end = end;
  if (heard.steps.size() > end.steps)
    complain(event.request(), std::to_string(heard.steps.size()) + " steps, but " + describe(end));
}

void Observer::take(const msg::Step& step, std::span<const std::byte> octets) {
  const std::uint64_t hash = std::hash<std::string_view>{}({reinterpret_cast<const char*>(octets.data()), octets.size()}) | 1;
  const std::lock_guard lock(mutex_);
  ++steps_;
  Heard& heard = heard_[step.request()];
  if (heard.steps.size() <= step.index()) heard.steps.resize(step.index() + 1);
  std::uint64_t& known = heard.steps[step.index()];
  if (known != 0 && known != hash) complain(step.request(), "two contents of step " + std::to_string(step.index()));
  known = hash;
  if (heard.ended && step.index() >= heard.end.steps)
    complain(step.request(), "step " + std::to_string(step.index()) + " after " + describe(heard.end));
  for (const msg::Margin& margin : step.margins())
    if (!(margin.value() >= margin.least()))
      complain(step.request(), "step " + std::to_string(step.index()) + ": " + margin.name() + " is " +
                                   std::to_string(margin.value()) + ", below " + std::to_string(margin.least()));
}

std::size_t Observer::finals() const {
  const std::lock_guard lock(mutex_);
  return finals_;
}

std::map<msg::Id, Final> Observer::final_states() const {
  const std::lock_guard lock(mutex_);
  std::map<msg::Id, Final> out;
  for (const auto& [id, heard] : heard_)
    if (heard.ended) out.emplace(id, heard.end);
  return out;
}

std::uint64_t Observer::events() const {
  const std::lock_guard lock(mutex_);
  return events_;
}

std::uint64_t Observer::steps() const {
  const std::lock_guard lock(mutex_);
  return steps_;
}

std::vector<std::string> Observer::complaints() const {
  const std::lock_guard lock(mutex_);
  return complaints_;
}

}  // namespace foothold::faults

// What a plan is given to work with: every step that it emits is judged, clothed with the judge's margins, and sent at once.
//
// The first step that is not fit to be sent ends the run: it and all after it stay here (PROTOCOL.md, P20).
#pragma once

#include <optional>

#include "foothold/planner.hpp"
#include "worker/channel.hpp"

namespace foothold::server {

// What became of a run's steps. Outlives the run's exceptions.
struct SentSteps {
  std::uint32_t count = 0;
  std::optional<msg::Error> refusal;  // why the run has to end, whatever plan() says
};

// What a run is about. References live as long as the run.
struct RunFacts {
  std::uint64_t run;
  const msg::PlanRequest& request;
  const Parameters& parameters;
  const PreparedScene& scene;
};

// Thread rule: the thread of plan() only.
class Stepper final : public PlanContext {
 public:
  Stepper(Planner& planner, const RunFacts& facts, Posture start, Channel& channel, std::stop_token stop_token, SentSteps& sent);

  bool emit(Step step) override;

 private:
  bool refuse(std::uint16_t code, std::string message);
  bool judge(const Step& step, StepVerdict& verdict);

  Planner& planner_;
  RunFacts facts_;
  Posture before_;
  Channel& channel_;
  SentSteps& sent_;
};

}  // namespace foothold::server

// Judging and sending one step.
#include "worker/stepper.hpp"

#include <cmath>
#include <new>

#include "foothold/msg/errors.hpp"
#include "text/text.hpp"
#include "worker/convert.hpp"

namespace foothold::server {

Stepper::Stepper(Planner& planner, const RunFacts& facts, Posture start, Channel& channel, std::stop_token stop_token,
                 SentSteps& sent)
    : planner_(planner), facts_(facts), before_(std::move(start)), channel_(channel), sent_(sent) {
  stop = std::move(stop_token);
  random.seed(facts.request.seed());
}

bool Stepper::refuse(std::uint16_t code, std::string message) {
  sent_.refusal = msg::make_error(code, "step " + std::to_string(sent_.count) + ": " + std::move(message));
  return false;
}

bool Stepper::judge(const Step& step, StepVerdict& verdict) {
  if (const auto fault = unsound_part(step)) return refuse(msg::STEP_REFUSED, *fault);
  verdict = planner_.check(step, before_, facts_.parameters, facts_.scene);
  if (!verdict.accepted)
    return refuse(msg::STEP_REFUSED, verdict.reason.empty() ? "check() refuses it without a reason" : cleaned(verdict.reason));
  for (const Margin& margin : verdict.margins) {
    if (!is_clean_text(margin.name) || !is_clean_text(margin.unit))
      return refuse(msg::STEP_REFUSED, "check() gives a margin whose name or unit is no clean text: " + quoted(margin.name));
    // Negated, so that a NaN is refused too.
    if (!(margin.value >= margin.least) || !std::isfinite(margin.value) || !std::isfinite(margin.least))
      return refuse(msg::STEP_REFUSED, "check() accepts it although its margin '" + margin.name + "' is " +
                                           std::to_string(margin.value) + " " + margin.unit + ", at least " +
                                           std::to_string(margin.least) + " is demanded");
  }
  return true;
}

bool Stepper::emit(Step step) {
  if (sent_.refusal || stop.stop_requested()) return false;
  const char* asked = "check()";
  try {
    StepVerdict verdict;
    if (!judge(step, verdict)) return false;
    msg::Step message = to_message(step);
    message.request(facts_.request.id());
    message.index(sent_.count);
    message.margins(to_message(verdict.margins));
    if (facts_.request.shapes()) {
      asked = "shapes()";
      const auto shapes = planner_.shapes(step.after);
      if (const auto fault = unsound_part(shapes)) return refuse(msg::STEP_REFUSED, *fault);
      message.shapes(to_message(shapes));
    }
    if (!channel_.fits(message)) return refuse(msg::OVERSIZE, "takes more than " + std::to_string(kLargestPayload >> 20) + " MiB");
    channel_.send(frame::STEP, facts_.run, message);
  } catch (const ChannelClosed&) {
    return refuse(msg::INTERNAL, "the daemon is gone");
  } catch (const std::bad_alloc&) {
    return refuse(msg::OUT_OF_MEMORY, std::string("no memory left in ") + asked);
  } catch (const std::exception& fault) {
    return refuse(msg::PLUGIN_THREW, std::string(asked) + " threw: " + cleaned(fault.what()));
  } catch (...) {
    return refuse(msg::PLUGIN_THREW, std::string(asked) + " threw something that is no std::exception");
  }
  before_ = std::move(step.after);
  ++sent_.count;
  return true;
}

}  // namespace foothold::server

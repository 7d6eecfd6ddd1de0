// The interface that a planner implements. A planner runs in a worker process of its own, is used by one thread at a time,
// includes no DDS, starts no thread that outlives plan(), installs no signal handler and draws random numbers only from its
// context.
#pragma once

#include <memory>
#include <random>
#include <stop_token>
#include <string>
#include <vector>

#include "foothold/errors.hpp"
#include "foothold/model.hpp"
#include "foothold/parameters.hpp"
#include "foothold/types.hpp"

namespace foothold {

// A scene file as the server stored it. `path` is empty when the request names no scene.
struct Scene {
  std::string name;
  std::string revision;  // SHA-256, lower-case hex
  std::string format;    // yaml, stl, obj, ply
  std::string path;
};

// What depends on the scene (and on those parameters that prepare() reads) alone; kept and shared by later requests.
class PreparedScene {
 public:
  virtual ~PreparedScene() = default;
  // The scene's geometry, for drawing. What stands in the way needs a height: an obstacle of a plane scene is given with walls as
  // high as the robot, or nothing of the robot is seen to cut it.
  virtual std::vector<Shape> shapes() const { return {}; }
};

// How good a plan is. The worker adds times, seed and versions. A report that contradicts itself is not passed on; its request
// ends FAILED / WORKER_PROTOCOL: a cost, bound or figure that is not finite; kReached with an error, or with a lower bound above
// the cost; kPartial or kFailed without an error; kStopped when nobody asked for it; `optimal` without a plan, or with a cost that
// differs from the lower bound by more than rounding.
struct PlanReport {
  enum class Outcome : std::uint32_t { kReached, kPartial, kFailed, kStopped };
  Outcome outcome = Outcome::kFailed;
  PlanError error = PlanError::kNone;  // of kPartial and kFailed
  std::uint16_t own_error = 0;         // 900 to 999 with `error_name`, instead of `error`
  std::string error_name;
  std::string field;
  std::string message;  // what happened, with the values
  std::string hint;     // what to do next
  double cost = 0.0;
  double lower_bound = 0.0;  // proved: no plan of this request costs less
  bool optimal = false;      // `cost` is proved least in the sense of `objective`
  std::string cost_unit;
  std::string objective;        // in words: what is least, over what set
  std::vector<Margin> figures;  // the planner's own, such as the distance left to the goal
};

// What plan() returns when it was told to stop, or when nothing more is wanted. Any thread.
inline PlanReport stopped_report() {
  PlanReport report;
  report.outcome = PlanReport::Outcome::kStopped;
  report.message = "stopped before the end of the search";
  return report;
}

// What plan() is given to work with.
class PlanContext {
 public:
  virtual ~PlanContext() = default;
  // Looked at every 5 ms of work at least; when stop is requested, plan() returns kStopped.
  std::stop_token stop;
  // The only source of random numbers: seeded from the request.
  std::mt19937_64 random;
  // Hands over the next step. The host judges it with check() and sends it at once. Returns false when nothing more is wanted
  // (step refused, plan stopped): plan() then returns kStopped. Call it from the thread that runs plan() only.
  // Refused without asking check(): numbers that are not finite, poses that are no rotation. Refused although check() accepts: a
  // margin below its least, more than 16 MiB.
  virtual bool emit(Step step) = 0;
};

class Planner {
 public:
  virtual ~Planner() = default;
  // What only depends on the scene and parameters; its result is shared by later requests. Throws InvalidScene.
  // The host keeps results by scene revision and by the parameters named in PlannerInfo::prepare_parameters.
  virtual std::shared_ptr<const PreparedScene> prepare(const Scene& scene, const Parameters& parameters) = 0;
  // The posture in which the request begins, from `request.start` or the planner's default. Throws InvalidRequest.
  virtual Posture start(const Request& request, const Parameters& parameters, const PreparedScene& scene) const = 0;
  // Emits steps in order. Throws InvalidRequest for a goal that makes no sense; reports everything else.
  virtual PlanReport plan(const Request& request, const Parameters& parameters, const PreparedScene& scene,
                          PlanContext& context) = 0;
  // Judges one step after the posture before it, without using the search's own tables.
  virtual StepVerdict check(const Step& step, const Posture& before, const Parameters& parameters,
                            const PreparedScene& scene) const = 0;
  // The robot's bodies in a posture, in the world: what collides is what is drawn.
  virtual std::vector<Shape> shapes(const Posture& posture) const = 0;
};

}  // namespace foothold

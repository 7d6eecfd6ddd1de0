// From half cycles to steps with contacts, postures and motion.
#include "route.hpp"

#include <string>

namespace foothold::xrobin {
namespace {

constexpr int kPerStroke = 8;  // motion points for each stroke of a piston

std::string state_name(const Configuration& c) {
  return std::string(1, c.l_extended ? '1' : '0') + (c.r_extended ? '1' : '0') + c.solution;
}

Contact contact(const char* limb, const PlanarPose& body) { return {limb, contact_frame(body), ""}; }

// The motion of one half cycle. Time runs with the length of the piston that moves, at constant speed.
std::vector<MotionPoint> motion(const Ring& ring, const BodyPoses& before, int from, const HalfCycle& half, bool a_holds,
                                double stroke_time) {
  const Mechanism& mechanism = ring.mechanism();
  const Lengths& lengths = mechanism.lengths();
  std::vector<MotionPoint> points;
  if (from == half.configuration) return points;
  Pistons last = mechanism.pistons(from);
  double time = 0.0;
  points.push_back({time, to_world(before.a), {last.l, last.r}});
  for (const SlotPosture& at : way_along(ring, from, half.configuration, half.way, kPerStroke)) {
    const Pistons now = mechanism.pistons(at.phi, at.y);
    time += stroke_time * (std::abs(now.l - last.l) + std::abs(now.r - last.r)) / (lengths.extended - lengths.retracted);
    const PlanarPose a = a_holds ? before.a : before.b * inverse(PlanarPose{0.0, at.y, at.phi});
    points.push_back({time, to_world(a), {now.l, now.r}});
    last = now;
  }
  return points;
}

}  // namespace

Route shortest_ways(int start_configuration, const Word& word) {
  Route route;
  int from = start_configuration;
  for (const int to : word) {
    route.push_back({to, shorter_way(from, to)});
    from = to;
  }
  return route;
}

Isometry3d contact_frame(const PlanarPose& body) { return to_world({body.x, body.y, body.heading + 0.5 * std::numbers::pi}); }

PlanarPose body_of_contact(const Isometry3d& frame) {
  return {frame.translation().x(), frame.translation().y(), wrapped(std::atan2(frame(1, 0), frame(0, 0)) - 0.5 * std::numbers::pi)};
}

Posture posture(const Mechanism& mechanism, const Stance& stance) {
  const Pistons pistons = mechanism.pistons(stance.configuration);
  const PlanarPose b = stance.a * mechanism.b_in_a(stance.configuration);
  return {to_world(stance.a), {pistons.l, pistons.r}, {contact("A", stance.a), contact("B", b)}};
}

std::vector<Step> to_steps(const Ring& ring, const Stance& start, const Route& route, std::size_t first_half, double stroke_time) {
  const Mechanism& mechanism = ring.mechanism();
  std::vector<Step> steps;
  BodyPoses now{start.a, start.a * mechanism.b_in_a(start.configuration)};
  int from = start.configuration;
  for (std::size_t k = 0; k < route.size(); ++k) {
    const HalfCycle& half = route[k];
    const bool a_holds = (first_half + k) % 2 == 0;
    const PlanarPose b_in_a = mechanism.b_in_a(half.configuration);
    BodyPoses after = now;
    if (a_holds)
      after.b = now.a * b_in_a;
    else
      after.a = now.b * inverse(b_in_a);

    const Configuration& reached = mechanism.configuration(half.configuration);
    const char* fixed = a_holds ? "A" : "B";
    const char* moving = a_holds ? "B" : "A";
    const int count = strokes(from, half.configuration, half.way);
    Step step;
    step.label = "cycle " + std::to_string((first_half + k) / 2 + 1) + ": " + fixed + " holds, " + moving + " to configuration " +
                 std::to_string(reached.number) + " (" + state_name(reached) + ")";
    step.motion = motion(ring, now, from, half, a_holds, stroke_time);
    const Pistons pistons = mechanism.pistons(half.configuration);
    step.after = {to_world(after.a), {pistons.l, pistons.r}, {contact("A", after.a), contact("B", after.b)}};
    step.placed = {a_holds ? contact("B", after.b) : contact("A", after.a)};
    step.attributes = {{"cycle", std::to_string((first_half + k) / 2 + 1)},
                       {"half_cycle", std::to_string(first_half + k + 1)},
                       {"configuration", std::to_string(reached.number)},
                       {"state", state_name(reached)},
                       {"fixed", fixed},
                       {"moving", moving},
                       {"strokes", std::to_string(count)},
                       {"ring", count == 0                 ? "stay"
                                : half.way == RingWay::kUp ? "up"
                                                           : "down"}};
    steps.push_back(std::move(step));
    now = after;
    from = half.configuration;
  }
  return steps;
}

}  // namespace foothold::xrobin

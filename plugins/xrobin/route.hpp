// A plan of Xrobin as the searches give it, and its translation into steps: one for each half cycle.
#pragma once

#include <vector>

#include "foothold/types.hpp"
#include "ring.hpp"
#include "word.hpp"

namespace foothold::xrobin {

// Where the robot stands: body A in the world and the configuration in which B is to it.
struct Stance {
  PlanarPose a;
  int configuration = 1;
};

// One half cycle: the configuration that it ends in and the way round the ring that leads there.
struct HalfCycle {
  int configuration = 1;
  RingWay way = RingWay::kUp;
};

using Route = std::vector<HalfCycle>;

// The route of a word with the shorter way round the ring for each half cycle.
Route shortest_ways(int start_configuration, const Word& word);

// The robot's posture for the host: base = body A, joints = l and r, contacts "A" and "B".
Posture posture(const Mechanism& mechanism, const Stance& stance);

// Body and contact frames differ: a body's slot or rail runs along its y axis, which is the contact's forward axis +X.
Isometry3d contact_frame(const PlanarPose& body);
PlanarPose body_of_contact(const Isometry3d& frame);

// Steps of a route from `start`; `first_half` is the index of its first half cycle in the whole plan (even: A holds).
// Costs are left 0.
std::vector<Step> to_steps(const Ring& ring, const Stance& start, const Route& route, std::size_t first_half, double stroke_time);

}  // namespace foothold::xrobin

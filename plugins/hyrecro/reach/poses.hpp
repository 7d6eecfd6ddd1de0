// Poses as the perceptrons see them: what their six inputs mean, and the random poses that they are trained and measured on.
//
// Inputs: position (m) and ZYX Euler angles (rad, R = Rz(rz) Ry(ry) Rx(rx)) of the free sole in the frame of the sole that holds,
// frames of the interface (+Z out of the surface, +X forward), in the order x, y, z, rx, ry, rz. Of the equal triples of angles the
// one with rx = 0 is taken; both kinds of pose have one, so that gimbal lock (a face at a right angle) is no special case.
//
// The robot is symmetric: each sole may be turned by half a turn about its normal (hip joints have no stops, plates are square),
// the whole posture may be mirrored (y), and it may be seen from the other foot. So sixteen poses are reachable together or not at
// all, and before a perceptron sees a pose, it is replaced by the one of the sixteen that lies in a fixed part of the space; the
// accuracy gains by it what sixteen times as many poses would give. Values; any thread.
#pragma once

#include <optional>
#include <random>

#include "hyrecro/model/model.hpp"
#include "hyrecro/reach/perceptron.hpp"

namespace foothold::hyrecro {

enum class PoseKind { kFace, kTransition };
const char* name_of(PoseKind kind);  // "face", "transition"

// Transition: a singular posture of the paper, the soles' Y axes (its Z axes) parallel or antiparallel within kSingular; face: both
// soles in one plane within 1e-6 m and rad. A pose that is both (heading difference 0 or half a turn) is a transition, since
// the inverse kinematics has its additional free variable. Empty: neither; no perceptron knows such poses.
std::optional<PoseKind> kind_of(const Isometry3d& free_in_holding);

// Precondition: the pose is of that kind.
NetworkInputs inputs_of(PoseKind kind, const Isometry3d& free_in_holding);
// The pose that inputs stand for.
Isometry3d pose_of(const NetworkInputs& inputs);

// Uniform in the ball (kFace: in the disc) of `radius` (m) round the sole that holds, headings uniform; kTransition: any bend, and
// antiparallel as often as parallel. The same for the same state of `random` on every machine.
Isometry3d random_pose(PoseKind kind, double radius, std::mt19937_64& random);

// Radius (m) round the sole that holds beyond which no foot gets in such a posture, from the legs alone and rounded up by some
// millimetres. kFace: 2 S + t, S the greatest lambda sin phi1.
double farthest(PoseKind kind, const Model& model);

// All numbers of the model on which reachability depends, as text: weights are valid for these only.
std::string robot_numbers(const Model& model);

}  // namespace foothold::hyrecro

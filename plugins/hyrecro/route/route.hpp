// What a search finds: footholds in order, each with the joint solution that reaches it; and how good the whole is.
#pragma once

#include <array>
#include <functional>
#include <random>
#include <stop_token>
#include <string>
#include <vector>

#include "foothold/errors.hpp"
#include "foothold/types.hpp"
#include "hyrecro/model/bodies.hpp"
#include "truss/truss.hpp"

namespace foothold::hyrecro {

using geometry::Polygon;
using geometry::Vector2d;

// A place where a gripper holds: on a face, in the face's frame; heading (rad) of the foot's X axis from the face's X axis, ccw
// seen from outside.
struct Foothold {
  int face = -1;
  Vector2d at = Vector2d::Zero();  // m
  double heading = 0.0;            // rad
};

// World pose of a sole there. Any thread.
Isometry3d pose_of(const truss::Truss& truss, const Foothold& foothold);
// Corners of the plate there, in the face's frame, counter-clockwise.
std::array<Vector2d, 4> footprint(const Model& model, const Foothold& foothold);

// The free foot is put to `to` while the other holds at the foothold before it. `coordinates` look from the foot that holds.
struct Stride {
  Foothold to;
  Coordinates coordinates;
};

struct Route {
  Foothold start;
  std::vector<Stride> strides;
};

// Way of the feet, m: from each foothold straight to the next. Any thread.
double length_of(const truss::Truss& truss, const Route& route);

// Why there is no route. `field` names the request's field if that is to blame.
struct Failure {
  PlanError error = PlanError::kNone;
  std::string field, message, hint;
};

struct Found {
  enum class Outcome { kReached, kFailed, kStopped };
  Outcome outcome = Outcome::kFailed;
  Route route;                  // of kReached
  Failure failure;              // of kFailed
  double cost = 0.0;            // strides, or metres when the objective is distance
  double lower_bound = 0.0;     // proved, in the same unit
  bool optimal = false;         // proved within `set`
  std::string objective;        // in words: what is least, over what set
  std::vector<Margin> figures;  // such as nodes expanded, length
};

enum class Objective { kSteps, kDistance };

// Two footholds that a route must not have one after the other, in either order: no motion was found between their stances. So are
// those on the same faces and no further away than `within` (m), in whatever heading.
struct Ban {
  Foothold one, other;
  double within = 0.0;
};

// Called for strides that the rest of the search cannot change any more, in order; false: stop. May be empty.
using OnStride = std::function<bool(const Stride&)>;

}  // namespace foothold::hyrecro

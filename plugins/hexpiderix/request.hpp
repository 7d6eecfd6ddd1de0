// What a request asks of Hex-piderix: parameters and start, judged and converted.
#pragma once

#include "foothold/planner.hpp"
#include "hexpiderix/adapt/adapt.hpp"
#include "hexpiderix/walk/walk.hpp"

namespace foothold::hexpiderix {

struct Options {
  AdaptOptions adapt;
  WalkOptions walk;
  Legs supports = kTriad1;
  bool any_place = false;  // for legs that join
  double clearance = 0.0;  // m
  double snap = 0.0;       // m
};

// Throws InvalidRequest for combinations that make no sense, with the parameter at fault.
Options read_options(const Parameters& parameters);

// The robot as it begins: with joints, exactly as they say, its supporting feet named by contacts or else all that are on the
// ground within 1e-4 m; without joints, standing on the ground at `start.base` with its heading, as the paper's robot after the
// slope changed under it. Points and normals of all six legs are filled in, where the ground is in reach.
struct Start {
  Situation situation;
  Coordinates at;
};
// Throws InvalidRequest: nothing given, off the ground, feet that do not meet the ground, less than three supports.
Start read_start(const Model& model, const Ground& ground, const Options& options, const Placement& start);

// To walk the robot begins on six feet, standing at `start.base`, where it can. Throws InvalidRequest.
Stand read_stand(const Model& model, const Ground& ground, const Options& options, const Placement& start);
// Where to walk; with any_orientation the heading stays. Throws InvalidRequest.
Station read_goal(const Ground& ground, const Options& options, const Stand& from, const Placement& goal);
// A request with a goal is one to walk.
bool is_walk(const Request& request);

}  // namespace foothold::hexpiderix

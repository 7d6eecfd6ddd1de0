// What a request asks of Hex-piderix: parameters and start, judged and converted.
#pragma once

#include "foothold/planner.hpp"
#include "hexpiderix/adapt/adapt.hpp"
#include "hexpiderix/ground.hpp"

namespace foothold::hexpiderix {

struct Options {
  AdaptOptions adapt;
  Legs supports = kTriad1;
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

}  // namespace foothold::hexpiderix

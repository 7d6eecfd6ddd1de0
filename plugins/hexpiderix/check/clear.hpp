// The judge's bodies: nothing of the robot is nearer to the terrain or to another part of it than the clearance.
#pragma once

#include "hexpiderix/check/skeleton.hpp"
#include "terrain/surface.hpp"

namespace foothold::hexpiderix {

// A foot is a point: a tibia's toe is not judged against the terrain, since a leaning leg of finite thickness always touches it
// there. Throws judge::Refusal that names the bodies. `supports`: legs whose feet stand. `which`: the posture, for people.
void judge_clear(const Model& model, const terrain::Surface& surface, const Isometry3d& base, const Skeleton& at, Legs supports,
                 double clearance, const char* which);

}  // namespace foothold::hexpiderix

// What is removed from a path that was found (Bioloid paper, section II.D). Free functions of values; any thread.
//
// `stop` is looked at for every point; a path whose removal was stopped is valid, and longer than it needed to be.
#pragma once

#include <stop_token>
#include <vector>

#include "bioloid/paper/space.hpp"

namespace foothold::bioloid::paper {

// Without useless sections: "situations in which the joints move and come back to a position without a total displacement or
// without evading a restriction". Loops (a point comes again: what lies between goes), then movements that lead nowhere: from every
// point on to the last later one that a single iteration reaches, no coordinate by more than a step, where that movement is valid.
std::vector<Point> without_useless_sections(const Space& space, const std::vector<Point>& path, std::stop_token stop = {});

// The last trimming: from every point on to the last later one of equal Cartesian position (Space::equal);
// what lies between is cut. The two points may differ in their joints, by more than a step: where the movement between them is
// not valid the cut is not made, and an earlier point of that position is tried.
std::vector<Point> trimmed(const Space& space, const std::vector<Point>& path, std::stop_token stop = {});

}  // namespace foothold::bioloid::paper

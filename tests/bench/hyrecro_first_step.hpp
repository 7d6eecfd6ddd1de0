// From submit() until the client has the first step of a plan on the paper's crossed beams, over DDS, with the real server.
#pragma once

#include <string>
#include <vector>

namespace foothold::bench {

// Milliseconds of `count` plans, one after the other, by server and client of `vendor`; the server has planned on the scene before.
// `motion`: whether steps carry motions. Throws std::runtime_error if a plan does not succeed.
std::vector<double> first_steps(const std::string& vendor, bool motion, int count);

}  // namespace foothold::bench

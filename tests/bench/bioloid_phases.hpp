// Single supports to plan in the nine free joints, the same for every planner, and what each planner made of them.
#pragma once

#include <ctime>
#include <memory>
#include <random>
#include <vector>

#include "bioloid/gait/swing.hpp"
#include "bioloid/posture/judge.hpp"

namespace foothold::bench {

inline double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// From the swing foot lifted behind to lifted ahead, feet parallel.
struct SinglePhase {
  bioloid::Support support;
  bioloid::Joints a, b;
  bioloid::Free from, to;
  std::unique_ptr<bioloid::Judge> judge;
};

// `sill`: with a sill beside the supporting foot, higher than the foot is lifted at both ends: the straight line in the joints hits
// it.
std::vector<SinglePhase> single_phases(const bioloid::Model& model, std::size_t count, bool sill, std::mt19937_64& random);

// One planner's answers to a set of phases.
struct Answers {
  std::vector<double> seconds;  // CPU time of each; what was not solved counts with its time too
  std::vector<double> travel;   // rad, of all joints together, of what was solved
  std::size_t solved = 0;
};

// Adds a path in the free joints, certified once more. Empty, or not sound: not solved, and false.
bool add(const bioloid::Model& model, const SinglePhase& phase, double seconds, const std::vector<bioloid::Free>& path,
         Answers& out);

}  // namespace foothold::bench

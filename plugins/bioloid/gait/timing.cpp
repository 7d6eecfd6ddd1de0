// Durations from the greatest joint speeds along the eased path.
#include "bioloid/gait/timing.hpp"

#include <algorithm>

namespace foothold::bioloid {

double least_time(const Model& model, const Joints& a, const Joints& b, double share) {
  double time = 0.0;
  for (std::size_t i = 0; i < kJoints; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    time = std::max(time, std::abs(b[row] - a[row]) / (share * model.joints[i].speed));
  }
  return time;
}

double duration(const Model& model, const JointPath& path, const Pace& pace) {
  constexpr int kLooks = 16;
  constexpr double kReserve = 1.05;  // rates between the looks
  Joints last, next;
  if (!path(0.0, last)) return -1.0;
  double longest = 0.0;
  for (int k = 1; k <= kLooks; ++k) {
    if (!path(eased(static_cast<double>(k) / kLooks), next)) return -1.0;
    longest = std::max(longest, least_time(model, last, next, pace.share));
    last = next;
  }
  return std::max(1.0, std::ceil(kReserve * longest * kLooks / pace.period)) * pace.period;
}

}  // namespace foothold::bioloid

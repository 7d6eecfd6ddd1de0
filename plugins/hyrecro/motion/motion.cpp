#include "hyrecro/motion/motion.hpp"

#include <cmath>
#include <numbers>

#include "hyrecro/motion/move.hpp"
#include "hyrecro/motion/rise.hpp"
#include "hyrecro/motion/transfer.hpp"

namespace foothold::hyrecro {
namespace {

// s, added to each part: the difference of two times or of two joints is rounded, and a part may be so short that this alone would
// make it too fast.
constexpr double kRounding = 1e-11;

// Appends points without jumps in the hips, those in between that keep hips below a quarter turn, and their times.
class Writer {
 public:
  explicit Writer(const Model& model) : model_(model) {}

  // Hips of `c` are taken to the nearest turn; `q` are taken as they are.
  void add(const Coordinates& c) {
    const Actuators q = to_actuators(model_, c);
    add(motion.points.empty() ? q : with_nearest_turns(last_, q), &c);
  }
  void add(const Actuators& q, const Coordinates* exact = nullptr) {
    if (motion.points.empty()) {
      put(q, exact, 0.0);
      return;
    }
    const Actuators begin = last_, way = q - begin;
    const double time = motion.times.back(), least = duration(model_, begin, q);
    if (least <= 0.0) return;
    const int pieces = 1 + static_cast<int>(way.tail<2>().cwiseAbs().maxCoeff() / (0.499 * std::numbers::pi));
    const double all = least * (1.0 + 1e-9) + pieces * kRounding;
    for (int i = 1; i <= pieces; ++i) {
      const double part = static_cast<double>(i) / pieces;
      put(i == pieces ? q : Actuators(begin + part * way), i == pieces ? exact : nullptr, time + part * all);
    }
  }

  Motion motion;

 private:
  void put(const Actuators& q, const Coordinates* exact, double time) {
    Coordinates c = exact ? *exact : from_actuators(model_, q);
    c.hip = {q[8], q[9]};
    motion.points.push_back(c);
    motion.times.push_back(time);
    last_ = q;
  }

  const Model& model_;
  Actuators last_ = Actuators::Zero();
};

}  // namespace

MotionResult move(const Surroundings& around, const Coordinates& from, const Coordinates& to, bool free_lifts,
                  const MotionOptions& options, const Effort& effort, std::mt19937_64& random) {
  std::string reason;
  std::optional<std::vector<Coordinates>> up{{from}};
  if (free_lifts) up = rise(around, from, options, effort.whole_begin, reason);
  if (!up) return {std::nullopt, "the foot cannot leave its surface: " + reason};
  const auto down = rise(around, to, options, effort.whole_end, reason);
  if (!down) return {std::nullopt, "the foot cannot be set down: " + reason};

  Writer writer(around.model);
  for (const Coordinates& c : *up) writer.add(c);
  Actuators begin = to_actuators(around.model, up->back());
  begin.tail<2>() << writer.motion.points.back().hip[0], writer.motion.points.back().hip[1];
  const auto way = transfer(around, begin, to_actuators(around.model, down->back()), effort.search, random, reason);
  if (!way) return {std::nullopt, reason};
  for (std::size_t i = 1; i < way->points.size(); ++i) writer.add(way->points[i]);
  for (std::size_t i = down->size() - 1; i-- > 0;) writer.add((*down)[i]);
  writer.motion.clearance = options.clearance;
  return {std::move(writer.motion), ""};
}

MotionResult plan_motion(const Model& model, const Obstacles& obstacles, const Isometry3d& holding, const Coordinates& from,
                         const Coordinates& to, bool free_lifts, const MotionOptions& options, std::mt19937_64& random,
                         const std::stop_token& stop) {
  return move(Surroundings{model, obstacles, holding, options.clearance, stop}, from, to, free_lifts, options, Effort{}, random);
}

std::vector<std::vector<double>> joint_rows(const Model& model, const Motion& motion, Foot holds, std::span<const double> before) {
  std::vector<std::vector<double>> out;
  out.reserve(motion.points.size());
  std::span<const double> last = before;
  for (const Coordinates& point : motion.points) {
    std::vector<double> row = to_joints(model, point, holds);
    if (!last.empty())
      for (std::size_t i = kJoints - 2; i < kJoints; ++i)
        row[i] = last[i] + std::remainder(row[i] - last[i], 2.0 * std::numbers::pi);
    out.push_back(std::move(row));
    last = out.back();
  }
  return out;
}

}  // namespace foothold::hyrecro

#include "fixtures.hpp"

#include <cmath>
#include <numbers>

#include "foothold/robot_file.hpp"
#include "hyrecro/motion/solutions.hpp"

namespace foothold::hyrecro::testing {
namespace {

truss::Solid box(const Vector3d& centre, const Vector3d& half) {
  truss::Solid out;
  out.name = "box";
  out.pose.translation() = centre;
  out.half = half;
  return out;
}

double turn_between(double a, double b) { return std::fabs(std::remainder(a - b, 2.0 * std::numbers::pi)); }

std::string same_joints(const Coordinates& a, const Coordinates& b) {
  const std::vector<double> x = to_joints(shipped_model(), a, Foot::kA), y = to_joints(shipped_model(), b, Foot::kA);
  for (std::size_t i = 0; i < kJoints; ++i)
    if ((i < 8 ? std::fabs(x[i] - y[i]) : turn_between(x[i], y[i])) > 1e-12) return "joint " + std::to_string(i) + " differs";
  return "";
}

}  // namespace

const Model& shipped_model() {
  static const Model model = Model::from_model(load_robot_model(FOOTHOLD_CONFIG_DIR "/robots/hyrecro.yaml"));
  return model;
}

truss::Truss plane() {
  truss::Truss out;
  out.solids.push_back(box({0.0, 0.0, -0.05}, {2.0, 2.0, 0.05}));
  return out;
}

truss::Truss plane_with_plate(double at, double begin, double end, double height, double thickness) {
  truss::Truss out = plane();
  out.solids.push_back(box({at, 0.5 * (begin + end), 0.5 * height}, {0.5 * thickness, 0.5 * (end - begin), 0.5 * height}));
  return out;
}

double uniform(std::mt19937_64& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

std::optional<Coordinates> random_solution(const Obstacles& obstacles, const Isometry3d& holding, const Isometry3d& free_in_holding,
                                           std::mt19937_64& random, double clearance) {
  std::vector<Coordinates> all = solutions(shipped_model(), free_in_holding, {0.1, 0.02, 0.2}, nullptr);
  for (int tries = 0; tries < 20 && !all.empty(); ++tries) {
    const Coordinates& c = all[random() % all.size()];
    const Bodies bodies = bodies_at(shipped_model(), c, holding);
    if (free_of_itself(bodies, clearance) && obstacles.free(bodies, clearance)) return c;
  }
  return std::nullopt;
}

Coordinates random_stance(const Obstacles& obstacles, std::mt19937_64& random, double clearance) {
  for (;;) {
    const double distance = uniform(random, 0.15, 0.5), direction = uniform(random, -std::numbers::pi, std::numbers::pi);
    const double heading = random() % 3 == 0 ? 0.0 : uniform(random, -std::numbers::pi, std::numbers::pi);
    Isometry3d pose(Eigen::AngleAxisd(heading, Vector3d::UnitZ()));
    pose.translation() << distance * std::cos(direction), distance * std::sin(direction), 0.0;
    if (const auto c = random_solution(obstacles, Isometry3d::Identity(), pose, random, clearance)) return *c;
  }
}

std::string fault_of(const Obstacles& obstacles, const Isometry3d& holding, const Coordinates& from, const Coordinates& to,
                     bool free_lifts, const MotionOptions& options, const Motion& motion, int samples) {
  const Model& model = shipped_model();
  if (motion.points.size() != motion.times.size() || motion.points.size() < 2) return "points without times";
  if (const std::string fault = same_joints(motion.points.front(), from); !fault.empty()) return "the begin's " + fault;
  if (const std::string fault = same_joints(motion.points.back(), to); !fault.empty()) return "the end's " + fault;
  if (motion.times.front() != 0.0) return "the first time is not 0";

  const std::vector<std::vector<double>> rows = joint_rows(model, motion, Foot::kA, {});
  for (std::size_t k = 1; k < rows.size(); ++k) {
    const double time = motion.times[k] - motion.times[k - 1];
    if (!(time > 0.0)) return "times do not grow";
    for (std::size_t i = 0; i < kJoints; ++i) {
      const double speed = std::fabs(rows[k][i] - rows[k - 1][i]) / time;
      if (speed > (i < 8 ? model.actuator_speed : model.hip_speed)) return "joint " + std::to_string(i) + " is too fast";
    }
  }

  const Isometry3d begin = forward(model, from), end = forward(model, to);
  // What the free sole's way from `at` looks like: height over it along its normal, and how far off the line.
  const auto line = [&](const Isometry3d& at, const Isometry3d& sole) {
    const Isometry3d off = at.inverse() * sole;
    return std::pair{off.translation().z(), std::max({off.translation().head<2>().norm(), -off.translation().z(),
                                                      Eigen::AngleAxisd(off.linear()).angle()})};
  };
  struct Sample {
    double height_begin, off_begin, height_end, off_end;
  };
  std::vector<Sample> all;
  const double last = motion.times.back();
  std::size_t k = 1;
  for (int s = 0; s <= samples; ++s) {
    const double time = last * s / samples;
    while (k + 1 < rows.size() && motion.times[k] < time) ++k;
    const double part = (time - motion.times[k - 1]) / (motion.times[k] - motion.times[k - 1]);
    std::vector<double> row(kJoints);
    for (std::size_t i = 0; i < kJoints; ++i) row[i] = rows[k - 1][i] + part * (rows[k][i] - rows[k - 1][i]);
    const Coordinates c = from_joints(model, row, Foot::kA);
    const std::string when = " at " + std::to_string(time) + " of " + std::to_string(last) + " s";
    if (!within_limits(model, c)) return "beyond a limit" + when;
    const Bodies bodies = bodies_at(model, c, holding);
    if (!free_of_itself(bodies, options.clearance - 1e-9)) return "the robot meets itself" + when;
    if (!obstacles.free(bodies, options.clearance - 1e-9))
      return "a solid is met by " + obstacles.nearest(bodies, options.clearance).body + when;
    const Isometry3d sole = forward(model, c);
    const auto [hb, ob] = line(begin, sole);
    const auto [he, oe] = line(end, sole);
    all.push_back({hb, ob, he, oe});
  }
  if (free_lifts)
    for (std::size_t i = 0; i < all.size() && all[i].height_begin < options.lift; ++i)
      if (all[i].off_begin > options.line_tolerance) return "off the line by which it leaves: " + std::to_string(all[i].off_begin);
  for (std::size_t i = all.size(); i-- > 0 && all[i].height_end < options.lift;)
    if (all[i].off_end > options.line_tolerance) return "off the line by which it arrives: " + std::to_string(all[i].off_end);
  return "";
}

}  // namespace foothold::hyrecro::testing

// See hyrecro_online.hpp.
#include "hyrecro_online.hpp"

#include <unistd.h>

#include <chrono>
#include <fstream>
#include <numbers>
#include <random>

#include "hyrecro/for_a_while.hpp"
#include "hyrecro/schema.hpp"

namespace foothold::bench {
namespace {

class Counter final : public PlanContext {
 public:
  bool emit(Step) override {
    ++steps;
    return true;
  }
  std::size_t steps = 0;
};

Isometry3d sole_at(const Vector3d& at, const Vector3d& up, const Vector3d& forward, double heading) {
  Isometry3d out = Isometry3d::Identity();
  out.linear() << forward, up.cross(forward), up;
  out.translation() = at;
  return out * Eigen::AngleAxisd(heading, Vector3d::UnitZ());
}

}  // namespace

Parameters hyrecro_parameters(const std::map<std::string, std::string>& set) {
  std::map<std::string, Parameters::Value, std::less<>> values;
  for (const ParameterSpec& spec : hyrecro::kParameters) {
    const auto given = set.find(spec.name);
    values.emplace(spec.name, parse_parameter(spec, given == set.end() ? spec.default_value : given->second.c_str()));
  }
  return Parameters(std::move(values));
}

Request hyrecro_request(const Isometry3d& start, const Isometry3d& goal) {
  Request request;
  request.start.contacts = {{"A", start, ""}};
  request.goal.contacts = {{"", goal, ""}};
  request.budget = 60.0;
  return request;
}

std::vector<Request> crossed_beams_requests(int count) {
  std::mt19937_64 random(2024);
  const auto between = [&](int low, int high) { return 0.01 * std::uniform_int_distribution<int>(low, high)(random); };
  const auto heading = [&] { return std::uniform_int_distribution<int>(0, 71)(random) * std::numbers::pi / 36.0; };
  std::vector<Request> out;
  while (static_cast<int>(out.size()) < count) {
    const Isometry3d start = sole_at({between(10, 60), 0.0, 0.075}, Vector3d::UnitZ(), Vector3d::UnitX(), heading());
    const double side = random() % 2 == 0 ? 1.0 : -1.0;
    const Isometry3d goal = sole_at({1.5, 0.075 * side, between(15, 55)}, Vector3d(0.0, side, 0.0), Vector3d::UnitZ(), heading());
    out.push_back(hyrecro_request(start, goal));
  }
  return out;
}

Timed timed_plan(hyrecro::HyrecroPlanner& planner, const Request& request, const Parameters& parameters,
                 const PreparedScene& scene) {
  Counter counter;
  counter.random.seed(request.seed);
  Timed out;
  {
    // As the server does when a budget ends.
    const hyrecro::ForAWhile budget(request.budget, {});
    counter.stop = budget.token();
    const auto begin = std::chrono::steady_clock::now();
    out.report = planner.plan(request, parameters, scene, counter);
    out.ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
  }
  out.steps = counter.steps;
  return out;
}

double resident_mb() {
  std::ifstream file("/proc/self/statm");
  double whole = 0.0, resident = 0.0;
  file >> whole >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
}

}  // namespace foothold::bench

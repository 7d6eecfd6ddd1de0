// Key postures in closed form; travel along coupled joints.
#include "bioloid_phases.hpp"

#include <cmath>

#include "bioloid/gait/keys.hpp"

namespace foothold::bench {
namespace {

using namespace bioloid;

constexpr double kGrain = 0.05;  // rad, of a free joint between the postures of a line

double travel_of(const Model& model, const SinglePhase& phase, const std::vector<Free>& path) {
  std::vector<Joints> points(1);
  from_free(model, phase.support.foot, path.front(), points.back());
  for (std::size_t k = 1; k < path.size(); ++k) {
    const Free step = path[k] - path[k - 1];
    const int pieces = std::max(1, static_cast<int>(std::ceil(step.cwiseAbs().maxCoeff() / kGrain)));
    for (int i = 1; i <= pieces; ++i) {
      points.emplace_back();
      from_free(model, phase.support.foot, path[k - 1] + step * (static_cast<double>(i) / pieces), points.back());
    }
  }
  return travel(points);
}

}  // namespace

std::vector<SinglePhase> single_phases(const Model& model, std::size_t count, bool sill, std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const auto between = [&](double low, double high) { return low + (high - low) * unit(random); };
  constexpr double kHeight = 0.12;  // m, of the hips over the ankles
  std::vector<SinglePhase> out;
  while (out.size() < count) {
    SinglePhase phase;
    phase.support.foot = out.size() % 2 ? Side::kLeft : Side::kRight;
    const double side = phase.support.foot == Side::kRight ? 1.0 : -1.0;
    const double nearest = sill ? 0.056 : 0.02, y = beside(model, phase.support.foot).y + side * between(0.0, 0.01),
                 lift = between(0.008, 0.012);
    const auto key = [&](double x) {
      return key_posture(model, phase.support.foot, {.swing = {x, y, 0.0}, .lift = lift, .height = kHeight});
    };
    const auto a = key(-between(nearest, 0.062)), b = key(between(nearest, 0.062));
    if (!a || !b) continue;
    std::vector<Prism> prisms;
    if (sill) {
      const double near = side * 0.04, far = side * 0.15, left = std::max(near, far), right = std::min(near, far);
      prisms.push_back({"sill", {{-0.001, right}, {0.001, right}, {0.001, left}, {-0.001, left}}, lift + between(0.002, 0.006)});
    }
    phase.judge = std::make_unique<Judge>(model, Demands{}, prisms);
    phase.a = a->joints;
    phase.b = b->joints;
    phase.from = to_free(model, phase.support.foot, phase.a);
    phase.to = to_free(model, phase.support.foot, phase.b);
    if (phase.judge->posture(phase.a, phase.support) != Fault::kNone ||
        phase.judge->posture(phase.b, phase.support) != Fault::kNone)
      continue;
    if (sill && free_line(model, *phase.judge, phase.support, phase.from, phase.to, 0)) continue;
    out.push_back(std::move(phase));
  }
  return out;
}

bool add(const Model& model, const SinglePhase& phase, double seconds, const std::vector<Free>& path, Answers& out) {
  out.seconds.push_back(seconds);
  if (path.empty()) return false;
  for (std::size_t k = 1; k < path.size(); ++k)
    if (!free_line(model, *phase.judge, phase.support, path[k - 1], path[k], 0)) return false;
  ++out.solved;
  out.travel.push_back(travel_of(model, phase, path));
  return true;
}

}  // namespace foothold::bench

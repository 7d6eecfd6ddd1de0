// The gait along a way: the longest stride that goes, a shorter one where it does not, back where none does. First straight on,
// then round the places where that ended.
#include "hexpiderix/walk/walk.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "hexpiderix/walk/detour.hpp"
#include "hexpiderix/walk/footholds.hpp"
#include "hexpiderix/walk/half_cycle.hpp"
#include "hexpiderix/walk/stands.hpp"

namespace foothold::hexpiderix {
namespace {

constexpr std::array kStrides{1.0, 0.5, 0.25, 0.1};  // of the longest
constexpr long kMostTried = 4000;                    // half cycles, along one way
constexpr int kDetours = 6;

class Gait {
 public:
  // `way`: two stations or more.
  Gait(const Model& model, const Ground& ground, const WalkOptions& options, const std::vector<Station>& way)
      : model_(model), ground_(ground), options_(options), way_(way), judge_(model, ground.surface(), options) {
    until_.push_back(0.0);
    for (std::size_t k = 1; k < way.size(); ++k)
      until_.push_back(until_.back() + std::max((way[k].place - way[k - 1].place).head<2>().norm() / options.stride,
                                                std::abs(way[k].heading - way[k - 1].heading) / options.turn));
    half_cycles_ = std::max(1.0, until_.back());
  }

  Walk run(const Stand& begin, const std::stop_token& stop) {
    Walk out;
    std::vector<Node> path{{begin, 0.0, kTriad2, 0}};
    double farthest = -1.0;
    while (!path.empty()) {
      if (stop.stop_requested()) {
        out.end = Walk::End::kStopped;
        break;
      }
      Node& node = path.back();
      if (node.settled == 2) {
        out.end = Walk::End::kArrived;
        break;
      }
      if (judge_.judged() > kMostTried) break;
      if (node.tried == kStrides.size()) {
        ++node.tried;
        if (auto shifted = better_stand(node)) {
          path.push_back({shifted->to, node.progress, node.swings, 0, node.settled, true});
          out.half_cycles.push_back(*std::move(shifted));
        }
        continue;
      }
      if (node.tried > kStrides.size()) {
        path.pop_back();
        if (!out.half_cycles.empty()) out.half_cycles.pop_back();
        continue;
      }
      const double stride = kStrides[node.tried++] / half_cycles_;
      const double next = std::min(1.0, node.progress + stride);
      std::string because;
      auto done = half_cycle(node, next, stride, because);
      if (!done) {
        if (node.progress > farthest) {
          farthest = node.progress;
          out.because = because;
          out.farthest = at(node.progress).place;
        }
        continue;
      }
      Node after{done->to, next, ~node.swings, 0};
      after.settled = node.progress >= 1.0 ? node.settled + 1 : 0;
      out.half_cycles.push_back(*std::move(done));
      path.push_back(after);
    }
    out.tried = judge_.judged();
    if (out.end != Walk::End::kArrived) out.half_cycles.clear();
    std::erase_if(out.half_cycles, [](const HalfCycle& half) {
      return half.swinging.none() && half.way.front().thorax.isApprox(half.way.back().thorax, 1e-12);
    });
    return out;
  }

 private:
  struct Node {
    Stand stand;
    double progress;       // of the way
    Legs swings;           // next
    std::size_t tried;     // strides
    int settled = 0;       // tripods that stand where the goal wants them
    bool shifted = false;  // the thorax was just brought to where it stands best
  };

  Station at(double progress) const {
    const double here = progress * until_.back();
    std::size_t k = 1;
    while (k + 1 < way_.size() && until_[k] < here) ++k;
    const Station &a = way_[k - 1], &b = way_[k];
    const double length = until_[k] - until_[k - 1];
    const double part = length > 0.0 ? std::clamp((here - until_[k - 1]) / length, 0.0, 1.0) : progress;
    return {a.place + part * (b.place - a.place), a.heading + part * (b.heading - a.heading)};
  }

  // On all six feet, to the thorax' pose in which the next tripod stands best.
  std::optional<HalfCycle> better_stand(const Node& node) {
    const auto plane = plane_at(model_, ground_, at(node.progress));
    if (node.shifted || !plane) return std::nullopt;
    std::optional<HalfCycle> best;
    std::string because;
    double most = -std::numeric_limits<double>::infinity();
    any_stand(model_, ground_, at(node.progress), *plane, node.stand.feet, options_, because, [&](const Stand& stand) {
      Vector3d com;
      const double nesm = nesm_on(model_, stand.at, stand.feet, ~node.swings, com);
      if (nesm <= most) return false;
      auto done = judge_(node.stand, stand, Legs{}, because);
      if (done) {
        most = nesm;
        best = std::move(done);
      }
      return false;
    });
    return best;
  }

  // The swinging feet come down where they stand best for the half cycle after this one: in its middle.
  std::optional<HalfCycle> half_cycle(const Node& node, double next, double stride, std::string& because) {
    const Station station = at(next), ahead = at(std::min(1.0, next + 0.5 * stride));
    const auto plane = plane_at(model_, ground_, station), plane_ahead = plane_at(model_, ground_, ahead);
    if (!plane || !plane_ahead) {
      because = "there is no ground under a foot";
      return std::nullopt;
    }
    std::size_t leg = 0;
    const auto places = footholds_at(model_, ground_, ahead, *plane_ahead, options_.friction, leg);
    if (!places) {
      because = "leg " + std::to_string(leg + 1) + " finds no foothold";
      return std::nullopt;
    }
    Footholds feet = node.stand.feet;
    constexpr double kSamePlace = 1e-3;  // m: a foot that stands there already holds on
    Legs swinging;
    for (leg = 0; leg < kLegs; ++leg) {
      if (!node.swings[leg] || (places->points[leg] - feet.points[leg]).norm() < kSamePlace) continue;
      swinging[leg] = true;
      feet.points[leg] = places->points[leg];
      feet.normals[leg] = places->normals[leg];
    }
    std::optional<HalfCycle> out;
    any_stand(model_, ground_, station, *plane, feet, options_, because, [&](const Stand& stand) {
      out = judge_(node.stand, stand, swinging, because);
      return out.has_value();
    });
    return out;
  }

  const Model& model_;
  const Ground& ground_;
  const WalkOptions& options_;
  const std::vector<Station>& way_;
  std::vector<double> until_;  // half cycles of the longest stride up to each station
  HalfCycleJudge judge_;
  double half_cycles_ = 1.0;  // in all
};

// The station after the one nearest to where a try ended.
Vector3d next_on(const std::vector<Station>& way, const Vector3d& ended) {
  std::size_t nearest = 0;
  for (std::size_t k = 1; k < way.size(); ++k)
    if ((way[k].place - ended).head<2>().norm() < (way[nearest].place - ended).head<2>().norm()) nearest = k;
  return way[std::min(nearest + 1, way.size() - 1)].place;
}

}  // namespace

Walk walk(const Model& model, const Ground& ground, const Stand& from, const Station& goal, const WalkOptions& options,
          const std::stop_token& stop) {
  const Vector3d ahead = from.at.thorax.linear().col(0);
  const Station begin{from.at.thorax.translation(), std::atan2(ahead.y(), ahead.x())};
  const std::vector<Station> straight = straight_way(ground, begin, goal);
  Walk out = Gait(model, ground, options, straight).run(from, stop);
  if (out.end != Walk::End::kBlocked) return out;
  Detours detours(model, ground, begin, goal, options);
  detours.close(next_on(straight, out.farthest));
  for (int k = 0; k < kDetours; ++k) {
    const std::vector<Station> way = detours.find(stop);
    if (way.empty()) break;
    Walk round = Gait(model, ground, options, way).run(from, stop);
    round.tried += out.tried;
    out.tried = round.tried;
    if (round.end != Walk::End::kBlocked) return round;
    const Vector3d ended = round.farthest;
    if ((round.farthest - goal.place).head<2>().norm() < (out.farthest - goal.place).head<2>().norm()) out = round;
    detours.close(next_on(way, ended));
  }
  if (stop.stop_requested()) out.end = Walk::End::kStopped;
  return out;
}

}  // namespace foothold::hexpiderix

// Strides put together from pieces that are made once.
#include "bioloid/gait/gait.hpp"

#include <algorithm>

namespace foothold::bioloid {
namespace {

constexpr unsigned kAtBegin = 1;

Support on_one(Side foot) { return {.foot = foot}; }
Support on_both(Side foot, const PlanarPose& second) { return {.foot = foot, .both = true, .second = to_world(second)}; }

std::array<double, 5> key_of(Side side, const PlanarPose& at, double lift) {
  return {static_cast<double>(index_of(side)), at.x, at.y, at.heading, lift};
}

}  // namespace

PlanarPose rounded(const PlanarPose& pose) {
  const auto to_nano = [](double value) { return std::round(value * 1e9) / 1e9 + 0.0; };
  return {to_nano(pose.x), to_nano(pose.y), to_nano(wrapped(pose.heading))};
}

Gait::Gait(const Model& model, const GaitOptions& options) : model_(model), options_(options), judge_(model, options.demands) {}

std::optional<KeyPosture> Gait::midway(Side support, const PlanarPose& swing) const {
  return key_posture(
      model_, support,
      {.swing = swing, .heading = 0.5 * swing.heading, .height = options_.height, .balance = {0.5 * swing.x, 0.5 * swing.y}});
}

Eigen::Vector2d Gait::weight_on_one(const PlanarPose& swing) const {
  if (options_.paper) return Eigen::Vector2d::Zero();
  const double inside = options_.demands.balance + options_.reserve;
  const Eigen::Vector2d most(std::max(0.0, 0.5 * model_.sole_length - inside), std::max(0.0, 0.5 * model_.sole_width - inside));
  return Eigen::Vector2d(0.5 * swing.x, 0.5 * swing.y).cwiseMax(-most).cwiseMin(most);
}

const Departure& Gait::departure(Side support, const PlanarPose& swing, double lift) {
  const auto [known, is_new] = departures_.try_emplace(key_of(support, swing, lift));
  if (is_new) known->second = make_departure(support, swing, lift, options_.pace);
  return known->second;
}

const Departure& Gait::rough_departure(Side support, const PlanarPose& swing, double lift) {
  const auto [known, is_new] = rough_departures_.try_emplace(key_of(support, swing, lift));
  if (is_new) known->second = make_departure(support, swing, lift, rough());
  return known->second;
}

Departure Gait::make_departure(Side support, const PlanarPose& swing, double lift, const Pace& pace) {
  Departure out;
  out.fault = Fault::kLimit;
  Key key{.swing = swing, .heading = 0.5 * swing.heading, .height = options_.height, .balance = weight_on_one(swing)};
  const auto between = midway(support, swing), over = key_posture(model_, support, key);
  key.lift = lift;
  const auto raised = key_posture(model_, support, key);
  if (!between || !over || !raised) return out;

  const double z = pelvis_height(model_, options_.height);
  const JointPath shift = [&](double s, Joints& joints) {
    joints = model_.carrying;
    const Eigen::Vector2d at = between->pelvis + s * (over->pelvis - between->pelvis);
    return stand(model_, support, {at.x(), at.y(), 0.5 * swing.heading}, z, swing, 0.0, joints);
  };
  out.shift = make_phase("shift", model_, judge_, on_both(support, swing), shift, pace, 0);
  out.fault = out.shift.fault;
  if (!out.sound()) return out;

  const Free low = to_free(model_, support, over->joints);
  out.raised = to_free(model_, support, raised->joints);
  out.lift = make_phase("lift", model_, judge_, on_one(support), swing_line(model_, support, low, out.raised), pace, kAtBegin);
  out.fault = out.lift.fault;
  return out;
}

const std::vector<Phase>& Gait::carry(Side support, const PlanarPose& from, const PlanarPose& to, double lift,
                                      std::mt19937_64& random, std::stop_token stop) {
  const Way way{static_cast<double>(index_of(support)), from.x, from.y, from.heading, to.x, to.y, to.heading, lift};
  const auto [known, is_new] = carries_.try_emplace(way);
  if (is_new) known->second = make_carry(support, from, to, lift, random, stop);
  return known->second;
}

std::optional<Phase> Gait::carry_line(const Support& support, const Free& a, const Free& b, const Pace& pace) {
  Phase phase = make_phase("carry", model_, judge_, support, swing_line(model_, support.foot, a, b), pace, 0);
  if (!phase.sound()) return std::nullopt;
  return phase;
}

std::vector<Phase> Gait::make_carry(Side support, const PlanarPose& from, const PlanarPose& to, double lift,
                                    std::mt19937_64& random, std::stop_token stop) {
  const Departure &begin = departure(support, from, lift), &end = departure(support, to, lift);
  if (!begin.sound() || !end.sound()) return {};
  const Support one = on_one(support);
  if (options_.paper) return paper_carry(judge_, support, {}, from, to, lift, random, stop);
  if (auto line = carry_line(one, begin.raised, end.raised, options_.pace)) return {std::move(*line)};
  std::vector<Phase> out = carry_beside(support, from, to, lift);
  if (!out.empty()) return out;
  const std::vector<Free> way = connect(model_, judge_, one, begin.raised, end.raised, options_.search, random, stop);
  for (std::size_t k = 1; k < way.size(); ++k) {
    auto line = carry_line(one, way[k - 1], way[k], options_.pace);
    if (!line) return {};
    out.push_back(std::move(*line));
  }
  return out;
}

std::vector<Phase> Gait::carry_beside(Side support, const PlanarPose& from, const PlanarPose& to, double lift) {
  const Departure &begin = departure(support, from, lift), &end = departure(support, to, lift);
  const Departure& middle = departure(support, beside(model_, support), lift);
  if (!begin.sound() || !end.sound() || !middle.sound()) return {};
  auto there = carry_line(on_one(support), begin.raised, middle.raised, options_.pace),
       on = carry_line(on_one(support), middle.raised, end.raised, options_.pace);
  if (!there || !on) return {};
  return {std::move(*there), std::move(*on)};
}

std::vector<Phase> Gait::paper_carry(Judge& judge, Side support, const PlanarPose& sole, const PlanarPose& from,
                                     const PlanarPose& to, double lift, std::mt19937_64& random, std::stop_token stop) {
  const Departure &begin = departure(support, from, lift), &end = departure(support, to, lift);
  if (!begin.sound() || !end.sound()) return {};
  auto way = paper_way(model_, judge, {.foot = support, .at = to_world(sole)}, begin.raised, end.raised, options_.pace,
                       *options_.paper, paper_figures_, random, stop);
  if (!way) return {};
  way->support = on_one(support);
  return {std::move(*way)};
}

bool Gait::may_be_placeable(Side support, const PlanarPose& swing, double lift) const {
  const auto known = placeable_.find(key_of(support, swing, lift));
  return known == placeable_.end() || known->second;
}

bool Gait::placeable(Side support, const PlanarPose& swing, double lift) {
  const auto [known, is_new] = placeable_.try_emplace(key_of(support, swing, lift));
  if (!is_new) return known->second;
  const auto reachable = [&](Side foot, const PlanarPose& place) {
    const Departure& leaves = rough_departure(foot, place, lift);
    const Departure& middle = rough_departure(foot, beside(model_, foot), lift);
    return leaves.sound() && middle.sound() && carry_line(on_one(foot), leaves.raised, middle.raised, rough()).has_value();
  };
  known->second = reachable(support, swing) && reachable(other(support), rounded(inverse(swing)));
  return known->second;
}

std::optional<Stride> Gait::stride(Side support, const PlanarPose& from, const PlanarPose& to, double lift, std::mt19937_64& random,
                                   std::stop_token stop) {
  return stride_with(support, from, to, lift, carry(support, from, to, lift, random, stop));
}

std::optional<Stride> Gait::stride_with(Side support, const PlanarPose& from, const PlanarPose& to, double lift,
                                        const std::vector<Phase>& way) {
  if (way.empty()) return std::nullopt;
  const Departure &begin = departure(support, from, lift), &end = departure(support, to, lift);
  Stride out{.support = support, .from = from, .to = to, .lift = lift, .phases = {begin.shift, begin.lift}};
  out.phases.insert(out.phases.end(), way.begin(), way.end());
  out.phases.push_back(reversed(end.lift));
  out.phases.back().name = "lower";
  out.phases.push_back(reversed(end.shift));
  out.phases.back().name = "settle";
  return out;
}

std::optional<Phase> Gait::rise(const Joints& from, Side support, const PlanarPose& swing) {
  const auto to = midway(support, swing);
  if (!to) return std::nullopt;
  const Support both = on_both(support, swing);
  // All joints at once, where that keeps both soles in place; else the pelvis straight on.
  const JointPath line = [&](double s, Joints& joints) {
    joints = from + s * (to->joints - from);
    return true;
  };
  Phase phase = make_phase("rise", model_, judge_, both, line, options_.pace, 0);
  if (phase.sound()) return phase;
  const Isometry3d begin = sole_in_torso(model_, support, from).inverse(),
                   end = sole_in_torso(model_, support, to->joints).inverse();
  const Eigen::Quaterniond first(begin.linear()), last(end.linear());
  const JointPath pelvis = [&](double s, Joints& joints) {
    joints = from + s * (to->joints - from);
    Isometry3d torso(first.slerp(s, last));
    torso.translation() = begin.translation() + s * (end.translation() - begin.translation());
    const Isometry3d seen = torso.inverse();
    return reach(model_, support, seen, joints) && reach(model_, other(support), seen * both.second, joints);
  };
  phase = make_phase("rise", model_, judge_, both, pelvis, options_.pace, 0);
  if (!phase.sound() || (phase.points.front() - from).cwiseAbs().maxCoeff() > 1e-9) return std::nullopt;
  return phase;
}

}  // namespace foothold::bioloid

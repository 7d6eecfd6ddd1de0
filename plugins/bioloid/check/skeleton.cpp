// Screws from the standing sole up to the torso and from there out into arms and the other leg.
#include "bioloid/check/skeleton.hpp"

#include <algorithm>
#include <cmath>

namespace foothold::bioloid::check {
namespace {

std::size_t carrier_of(const Model& model, std::size_t body) { return static_cast<std::size_t>(model.joints[body - 1].parent + 1); }

// Greatest distance of the body's boxes (and a foot's sole) from the point, all in its own frame.
double farthest(const Body& body, const Vector3d& point) {
  double most = (body.centre_of_mass - point).norm();
  for (const BodyBox& box : body.boxes) most = std::max(most, ((box.centre - point).cwiseAbs() + box.half).norm());
  return most;
}

}  // namespace

Skeleton::Skeleton(const Model& model, Side standing) : model_(model), mass_(model.mass()) {
  places_[0] = Vector3d::Zero();
  for (std::size_t j = 0; j < kJoints; ++j) places_[j + 1] = places_[carrier_of(model, j + 1)] + model.joints[j].origin;
  const Vector3d sole = places_[leg_joint(standing, 5) + 1] + model.sole(standing);
  for (Vector3d& place : places_) place -= sole;

  const auto line = [&](std::size_t joint) { return kinematics::Screw{model.joints[joint].axis, places_[joint + 1]}; };
  std::array<bool, kBodies> done{};
  done[0] = true;
  for (std::size_t k = kLegJoints; k-- > 0;) {
    const std::size_t joint = leg_joint(standing, k);
    done[joint + 1] = true;
    links_.push_back({carrier_of(model, joint + 1), joint + 1, static_cast<int>(joint), -1.0, line(joint)});
  }
  for (std::size_t body = 1; body < kBodies; ++body)
    if (!done[body]) links_.push_back({body, carrier_of(model, body), static_cast<int>(body - 1), 1.0, line(body - 1)});

  for (std::size_t body = 0; body < kBodies; ++body) {
    first_box_[body + 1] = first_box_[body] + model.bodies[body].boxes.size();
    find_reach(body);
    for (std::size_t other = 0; other < body; ++other)
      if (!model.neighbours(other, body) && !model.bodies[other].boxes.empty() && !model.bodies[body].boxes.empty())
        find_pair(other, body);
  }
}

// A point of the body is from a joint's line at most as far as the way there over the joints between, each a fixed length.
void Skeleton::find_reach(std::size_t body) {
  std::size_t at = body;
  Vector3d from = places_[body];
  double far = 0.0, centre = 0.0;
  bool first = true;
  for (auto link = links_.rbegin(); link != links_.rend(); ++link) {
    if (link->body != at) continue;
    const Vector3d& point = link->line.point;
    if (first) {
      far = farthest(model_.bodies[body], point - places_[body]);
      for (const Side side : {Side::kRight, Side::kLeft})
        if (body == leg_joint(side, 5) + 1)
          for (const Vector3d& corner : sole_corners(side)) far = std::max(far, (corner - point).norm());
      centre = (model_.bodies[body].centre_of_mass + places_[body] - point).norm();
    } else {
      far += (from - point).norm();
      centre += (from - point).norm();
    }
    first = false;
    from = point;
    reach_[body].push_back({link->joint, far, centre});
    at = link->carrier;
  }
  std::reverse(reach_[body].begin(), reach_[body].end());
}

// Seen from where their limbs part: each body's way from there adds its joints.
void Skeleton::find_pair(std::size_t a, std::size_t b) {
  const auto upwards = [&](std::size_t body) {
    std::vector<std::size_t> way{body};
    while (way.back() != 0) way.push_back(carrier_of(model_, way.back()));
    return way;
  };
  std::vector<std::size_t> ways[2] = {upwards(a), upwards(b)};
  while (ways[0].size() > 1 && ways[1].size() > 1 && ways[0][ways[0].size() - 2] == ways[1][ways[1].size() - 2]) {
    ways[0].pop_back();
    ways[1].pop_back();
  }
  Pair pair{a, b, {}};
  for (auto& way : ways) {
    way.pop_back();
    double far = 0.0;
    for (std::size_t i = 0; i < way.size(); ++i) {
      far += i == 0 ? farthest(model_.bodies[way[i]], Vector3d::Zero()) : (places_[way[i - 1]] - places_[way[i]]).norm();
      pair.levers.emplace_back(static_cast<int>(way[i] - 1), far);
    }
  }
  pairs_.push_back(std::move(pair));
}

Instant Skeleton::at(const Joints& joints) const {
  Instant out;
  out.moved[links_.front().carrier].setIdentity();  // the foot that stands
  out.boxes.reserve(first_box_.back());
  for (const Link& link : links_)
    out.moved[link.body] = out.moved[link.carrier] * kinematics::displacement(link.line, link.sign * joints[link.joint]);
  for (std::size_t body = 0; body < kBodies; ++body) {
    const Body& shape = model_.bodies[body];
    out.centre_of_mass += shape.mass * (out.moved[body] * (places_[body] + shape.centre_of_mass));
    for (const BodyBox& part : shape.boxes) {
      collision::Box& box = out.boxes.emplace_back();
      box.pose.linear() = out.moved[body].linear();
      box.pose.translation() = out.moved[body] * (places_[body] + part.centre);
      box.half = part.half;
    }
  }
  out.centre_of_mass /= mass_;
  return out;
}

Velocities Skeleton::velocities(const Instant& instant, const Joints& change) const {
  Velocities out;
  out.turn.fill(Vector3d::Zero());
  out.slide.fill(Vector3d::Zero());
  for (const Link& link : links_) {
    const Vector3d turn = link.sign * change[link.joint] * (instant.moved[link.carrier].linear() * link.line.axis);
    out.turn[link.body] = out.turn[link.carrier] + turn;
    out.slide[link.body] = out.slide[link.carrier] - turn.cross(instant.moved[link.carrier] * link.line.point);
  }
  for (std::size_t body = 0; body < kBodies; ++body)
    out.centre_of_mass +=
        model_.bodies[body].mass * out.of(body, instant.moved[body] * (places_[body] + model_.bodies[body].centre_of_mass));
  out.centre_of_mass /= mass_;
  return out;
}

// The second derivative by joints i and k, i nearer to the ground, is s_i x (s_k x (p - p_k)): no longer than k's lever.
Rates Skeleton::rates(const Joints& change) const {
  Rates out;
  for (std::size_t body = 0; body < kBodies; ++body) {
    double nearer = 0.0, centre = 0.0;
    for (const Reach& reach : reach_[body]) {
      const double rate = std::abs(change[reach.joint]);
      out.slope[body] += rate * reach.farthest;
      out.bend[body] += reach.farthest * rate * (rate + 2.0 * nearer);
      centre += reach.centre * rate * (rate + 2.0 * nearer);
      out.turn_bend[body] += rate * nearer;
      nearer += rate;
    }
    out.centre_bend += model_.bodies[body].mass / mass_ * centre;
  }
  return out;
}

double Skeleton::Pair::slope(const Joints& change) const {
  double sum = 0.0;
  for (const auto& [joint, lever] : levers) sum += lever * std::abs(change[joint]);
  return sum;
}

Vector3d Skeleton::sole(Side side) const { return places_[leg_joint(side, 5) + 1] + model_.sole(side); }

std::array<Vector3d, 4> Skeleton::sole_corners(Side side) const {
  const Vector3d x(0.5 * model_.sole_length, 0, 0), y(0, 0.5 * model_.sole_width, 0), at = sole(side);
  return {at + x + y, at - x + y, at - x - y, at + x - y};
}

}  // namespace foothold::bioloid::check

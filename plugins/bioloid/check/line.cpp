// Halving: a piece of the line is proved from its middle. Distances change no faster than the bodies' slopes; points stay as close
// to the tangent at the middle as their bound on the second derivative says. What cannot be shown is halved.
#include "bioloid/check/line.hpp"

#include <algorithm>
#include <cmath>

#include "contact/support_polygon.hpp"
#include "judge/refusal.hpp"

namespace foothold::bioloid::check {
namespace {

using judge::refuse;

constexpr double kClearanceProof = 1e-5;  // m, to which clearances are proved
constexpr double kProof = 1e-6;           // m and rad, to which all else is

std::size_t foot_of(Side side) { return leg_joint(side, 5) + 1; }

// The corners of the other foot's box and sole, where the zero pose has them.
std::vector<Vector3d> corners_of(const Judged& judged) {
  const auto sole = judged.skeleton.sole_corners(judged.moving);
  std::vector<Vector3d> out(sole.begin(), sole.end());
  const Vector3d foot = judged.skeleton.sole(judged.moving) - judged.model.sole(judged.moving);
  for (const BodyBox& box : judged.model.bodies[foot_of(judged.moving)].boxes)
    for (unsigned i = 0; i < 8; ++i)
      out.push_back(foot + box.centre +
                    box.half.cwiseProduct(Vector3d(i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0)));
  return out;
}

// m: the item's distance if it is below `needed` or the least that was seen; else `reserve` more than those at the most.
double measured(const Judged& judged, const Instant& instant, const Surroundings::Item& item, double needed, double reserve,
                double time, double tolerance, Seen& seen) {
  const bool ground = item.kind == Surroundings::Item::Kind::kGround;
  const double demanded = Surroundings::demanded(item, judged.options.clearance);
  const double found = judged.surroundings.distance(instant, item, (ground ? needed : std::max(needed, seen.clearance)) + reserve);
  if (!ground) seen.clearance = std::min(seen.clearance, found);
  if (found < demanded - tolerance)
    refuse("at ", time, " s: ", judged.surroundings.names(item), " are ", found, " m apart, less than ", demanded, " m");
  return found;
}

class Proof {
 public:
  Proof(const Judged& judged, const Line& line, const Support& support, Seen& seen)
      : judged_(judged), line_(line), support_(support), seen_(seen), corners_(corners_of(judged)) {}

  void run(const std::vector<std::size_t>& open) {
    Open all;
    for (const std::size_t item : open) all.items.emplace_back(judged_.surroundings.items()[item], line_.slopes[item]);
    piece(0.0, 1.0, std::move(all));
  }

 private:
  struct Open {
    std::vector<std::pair<Surroundings::Item, double>> items;
    bool balance = true, foot = true;
    bool none() const { return items.empty() && !balance && !foot; }
  };

  void piece(double from, double to, Open open) {
    const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
    const Instant instant = judged_.skeleton.at(line_.from + middle * line_.change);
    const double time = line_.begin + middle * (line_.end - line_.begin);
    if (open.balance || open.foot) {
      const Velocities velocities = judged_.skeleton.velocities(instant, line_.change);
      if (open.balance) open.balance = !balanced(instant, velocities, half, time);
      if (open.foot) open.foot = !(line_.stands ? fast(instant, velocities, half, time) : above(instant, velocities, half, time));
    }
    clear(instant, half, time, open.items);
    if (open.none()) return;
    piece(from, middle, open);
    piece(middle, to, std::move(open));
  }

  // Leaves in `items` what is still open.
  void clear(const Instant& instant, double half, double time, std::vector<std::pair<Surroundings::Item, double>>& items) {
    std::erase_if(items, [&](const auto& entry) {
      const double demanded = Surroundings::demanded(entry.first, judged_.options.clearance), moves = half * entry.second;
      const double found = measured(judged_, instant, entry.first, demanded + moves, 0.0, time, 0.5 * kClearanceProof, seen_);
      return found - moves >= demanded - kClearanceProof;
    });
  }

  bool balanced(const Instant& instant, const Velocities& velocities, double half, double time) {
    const Vector3d &at = instant.centre_of_mass, way = half * velocities.centre_of_mass;
    const double here = support_.margin(at), off = 0.5 * half * half * line_.rates.centre_bend;
    seen_.balance = std::min(seen_.balance, here);
    if (here < judged_.options.balance - 0.5 * kProof)
      refuse("at ", time, " s: the centre of mass is ", here, " m inside the soles' hull, less than ", judged_.options.balance,
             " m");
    return std::min(support_.margin(at - way), support_.margin(at + way)) - off >= judged_.options.balance - kProof;
  }

  // The other sole stays where it stands.
  bool fast(const Instant& instant, const Velocities& velocities, double half, double time) {
    const std::size_t foot = foot_of(judged_.moving);
    const Isometry3d sole = other_sole(judged_, instant);
    const Vector3d off = sole.translation() - line_.stands->translation();
    const Vector3d way = half * velocities.of(foot, sole.translation()), turn = half * velocities.turn[foot];
    const double here = judge::error_between(sole, *line_.stands), limit = judged_.options.slip;
    seen_.slip = std::min(seen_.slip, limit - here);
    if (here > limit + 0.5 * kProof)
      refuse("at ", time, " s: the standing ", name_at(kLimbs, index_of(judged_.moving)), " slips by ", off.norm(), " m and ",
             judge::turned(sole, *line_.stands), " rad, more than ", limit);
    const double bend = 0.5 * half * half;
    const double moved = std::max((off - way).norm(), (off + way).norm()) + bend * line_.rates.bend[foot];
    const double angle = turn.norm();
    const Vector3d axis = angle > 0.0 ? Vector3d(turn / angle) : Vector3d::UnitZ();
    double turned = 0.0;
    for (const double sense : {-1.0, 1.0})
      turned = std::max(turned, judge::turned(Eigen::AngleAxisd(sense * angle, axis) * sole, *line_.stands));
    return moved <= limit + kProof && turned + bend * line_.rates.turn_bend[foot] <= limit + kProof;
  }

  // The other sole is above the ground.
  bool above(const Instant& instant, const Velocities& velocities, double half, double time) {
    const std::size_t foot = foot_of(judged_.moving);
    double here = HUGE_VAL, least = HUGE_VAL;
    for (const Vector3d& corner : corners_) {
      const Vector3d at = instant.moved[foot] * corner;
      here = std::min(here, at.z());
      least = std::min(least, at.z() - half * std::abs(velocities.of(foot, at).z()));
    }
    seen_.ground = std::min(seen_.ground, here);
    seen_.lift = std::max(seen_.lift, here);
    if (here < -judged_.options.ground - 0.5 * kProof)
      refuse("at ", time, " s: the moving ", name_at(kLimbs, index_of(judged_.moving)), " is ", -here,
             " m below the ground, more than ", judged_.options.ground, " m");
    return least - 0.5 * half * half * line_.rates.bend[foot] >= -judged_.options.ground - kProof;
  }

  const Judged& judged_;
  const Line& line_;
  const Support& support_;
  Seen& seen_;
  std::vector<Vector3d> corners_;
};

}  // namespace

Support::Support(const Model& model, const std::optional<Isometry3d>& second) {
  std::vector<Vector3d> corners;
  for (const double x : {-0.5, 0.5})
    for (const double y : {-0.5, 0.5}) {
      const Vector3d corner(x * model.sole_length, y * model.sole_width, 0.0);
      corners.push_back(corner);
      if (second) corners.push_back(*second * corner);
    }
  const contact::SupportPolygon hull = contact::support_polygon(corners);
  for (std::size_t i = 0; i < hull.count; ++i) {
    const Eigen::Vector2d a = hull.corners[i].head<2>(), b = hull.corners[(i + 1) % hull.count].head<2>();
    const Eigen::Vector2d inward = Eigen::Vector2d(a.y() - b.y(), b.x() - a.x()).normalized();
    edges_.emplace_back(inward, -inward.dot(a));
  }
}

double Support::margin(const Vector3d& centre_of_mass) const {
  double least = HUGE_VAL;
  for (const auto& [inward, offset] : edges_) least = std::min(least, inward.dot(centre_of_mass.head<2>()) + offset);
  return least;
}

double lowest_corner(const Judged& judged, const Instant& instant) {
  double least = HUGE_VAL;
  for (const Vector3d& corner : judged.skeleton.sole_corners(judged.moving))
    least = std::min(least, (instant.moved[foot_of(judged.moving)] * corner).z());
  return least;
}

Isometry3d other_sole(const Judged& judged, const Instant& instant) {
  return instant.moved[foot_of(judged.moving)] * Eigen::Translation3d(judged.skeleton.sole(judged.moving));
}

Line line_between(const Judged& judged, const Joints& from, const Joints& to) {
  Line line{from, to - from, 0.0, 0.0, std::nullopt, {}, {}};
  line.rates = judged.skeleton.rates(line.change);
  for (const Surroundings::Item& item : judged.surroundings.items())
    line.slopes.push_back(judged.surroundings.slope(item, line.change, line.rates));
  return line;
}

Distances::Distances(const Judged& judged) : judged_(judged), bounds_(judged.surroundings.items().size(), 0.0) {}

void Distances::next(const Instant& instant, double time, const Line* before, const Line* after, Seen& seen) {
  constexpr double kReserve = 0.01;  // m, looked further than needed, so that the next points need not
  open_.clear();
  for (std::size_t i = 0; i < bounds_.size(); ++i) {
    const Surroundings::Item& item = judged_.surroundings.items()[i];
    const double demanded = Surroundings::demanded(item, judged_.options.clearance);
    const double came = before ? before->slopes[i] : 0.0, leaves = after ? after->slopes[i] : 0.0, old = bounds_[i];
    const double needed = demanded + 0.5 * std::max(came, leaves);
    const bool known = before && old - came >= std::max(needed, seen.clearance);
    bounds_[i] = known ? old - came : measured(judged_, instant, item, needed, kReserve, time, kClearanceProof, seen);
    if (before && 0.5 * (old + bounds_[i] - came) < demanded) open_.push_back(i);
  }
}

void prove(const Judged& judged, const Line& line, const Support& support, const std::vector<std::size_t>& open, Seen& seen) {
  Proof(judged, line, support, seen).run(open);
}

}  // namespace foothold::bioloid::check

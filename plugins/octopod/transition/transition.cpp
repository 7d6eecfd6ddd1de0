// From the order to a way in coordinates.
#include "octopod/transition/transition.hpp"

#include <algorithm>
#include <cmath>

#include "contact/critical_friction.hpp"
#include "octopod/transition/order.hpp"

namespace foothold::octopod {
namespace {

constexpr double kBulge = 2e-4;  // m, of a foot between two points of a way
constexpr double kSame = 1e-6;   // rad: legs on their standing branch
constexpr int kDeepest = 12;

// How far a foot can be off while joints are linear between two points: each link adds its length times the square of all turns up
// to it, an eighth of that is what the second derivative lets it bulge.
double bulge(const Model& model, const Coordinates& a, const Coordinates& b) {
  const double base = Eigen::AngleAxisd(Eigen::Matrix3d(a.front.linear().transpose() * b.front.linear())).angle();
  const double ball = 1.8 * a.ball.angularDistance(b.ball);  // the sum of three angles is not above sqrt(3) times the turn
  double worst = 0.0;
  for (std::size_t i = 0; i < kLegs; ++i) {
    double turns = base, sum = 0.0;
    if (i >= 4) {
      turns += ball;
      sum = model.arm() * (base * base + turns * turns);
    }
    const Vector3d joints = (b.legs[i] - a.legs[i]).cwiseAbs();
    sum += model.shoulders[i % 4].norm() * turns * turns;
    const double lengths[3] = {model.coxa, model.femur, model.tibia};
    for (Eigen::Index j = 0; j < 3; ++j) {
      turns += joints[j];
      sum += lengths[j] * turns * turns;
    }
    worst = std::max(worst, sum / 8);
  }
  return worst;
}

// Legs in closed form, bodies at `part` of their path.
struct Walker {
  const Model& model;
  const BodyPath& path;
  std::array<Vector3d, kLegs> feet;

  std::optional<Coordinates> at(double part) const { return reaching(model, path.at(part), feet); }
};

// Appends points from `last` (already there) to `end` so dense that joints may be linear between them. `at(part)` gives
// coordinates.
template <class At>
bool fill(const Model& model, const At& at, double begin, const Coordinates& first, double end, const Coordinates& last, int depth,
          std::vector<Coordinates>& way) {
  if (bulge(model, first, last) <= kBulge) {
    way.push_back(last);
    return true;
  }
  if (depth == kDeepest) return false;
  const double middle = (begin + end) / 2;
  const std::optional<Coordinates> between = at(middle);
  return between && fill(model, at, begin, first, middle, *between, depth + 1, way) &&
         fill(model, at, middle, *between, end, last, depth + 1, way);
}

template <class At>
bool go(const Model& model, const At& at, double begin, double end, std::vector<Coordinates>& way) {
  const std::optional<Coordinates> last = at(end);
  const Coordinates first = way.back();
  return last && fill(model, at, begin, first, end, *last, 0, way);
}

bool swing_over(const Setting& setting, const Passage& passage, Walker& walker, const Swing& swing, int leg, int phase,
                std::vector<Coordinates>& way) {
  const auto i = static_cast<std::size_t>(leg);
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector3d from = swing.points[k], to = swing.points[k + 1];
    const auto at = [&](double part) {
      walker.feet[i] = from + part * (to - from);
      return walker.at(passage.part(phase));
    };
    if (!go(setting.model, at, 0.0, 1.0, way)) return false;
  }
  walker.feet[i] = passage.footing(leg, true).point;
  return true;
}

double margin(const Setting& setting, const Passage& passage, contact::Equilibrium& equilibrium, unsigned moved, int lifted,
              int phase) {
  const Stance feet = stance(passage, moved, lifted);
  return setting.options.friction - contact::critical_friction(equilibrium, feet.span(), passage.centre_of_mass(moved, phase)).mu;
}

bool stands_naturally(const Model& model, const Standing& at) {
  std::array<Vector3d, kLegs> feet;
  for (std::size_t i = 0; i < kLegs; ++i) feet[i] = at.feet[i].point;
  const std::optional<Coordinates> natural = reaching(model, pair_of(model, at.at), feet);
  if (!natural) return false;
  for (std::size_t i = 0; i < kLegs; ++i)
    if ((natural->legs[i] - at.at.legs[i]).cwiseAbs().maxCoeff() > kSame) return false;
  return true;
}

bool fail(TransitionFailure* failure, const char* because) {
  if (failure != nullptr) *failure = {-1, because};
  return false;
}

bool begin_and_end(const Setting& setting, const Standing& from, const Standing& to, TransitionFailure* failure) {
  if (!stands_naturally(setting.model, from)) return fail(failure, "the first posture's legs are not on their standing branch");
  if (!stands_naturally(setting.model, to)) return fail(failure, "the second posture's legs are not on their standing branch");
  return true;
}

}  // namespace

bool has_transition(const Model& model, const terrain::Surface& surface, const TransitionOptions& options, const Standing& from,
                    const Standing& to) {
  const Setting setting{model, surface, options};
  Passage passage(setting, from, to);
  contact::Equilibrium equilibrium{contact::FrictionCone{options.cone_edges}};
  return find_order(passage, equilibrium, nullptr) && begin_and_end(setting, from, to, nullptr);
}

std::optional<Transition> transition(const Model& model, const terrain::Surface& surface, const TransitionOptions& options,
                                     const Standing& from, const Standing& to, TransitionFailure* failure) {
  const Setting setting{model, surface, options};
  Passage passage(setting, from, to);
  contact::Equilibrium equilibrium{contact::FrictionCone{options.cone_edges}};
  if (!begin_and_end(setting, from, to, failure)) return std::nullopt;
  const auto order = find_order(passage, equilibrium, failure);
  if (!order) return std::nullopt;

  Transition out;
  out.to = to;
  out.least_margin = margin(setting, passage, equilibrium, 0, -1, 0);
  Walker walker{model, passage.bodies(), {}};
  for (int leg = 0; leg < kLegs; ++leg) walker.feet[static_cast<std::size_t>(leg)] = passage.footing(leg, false).point;
  Coordinates now = from.at;
  unsigned moved = 0;
  int phase = 0;
  for (const Move& move : *order) {
    if (out.phases.empty() || move.leg >= 0 || out.phases.back().leg >= 0) out.phases.push_back({move.leg, {now}});
    std::vector<Coordinates>& way = out.phases.back().way;
    bool went = false;
    if (move.leg >= 0) {
      out.least_margin = std::min(out.least_margin, margin(setting, passage, equilibrium, moved, move.leg, phase));
      went = swing_over(setting, passage, walker, *passage.swing(move.leg, phase), move.leg, phase, way);
      moved |= 1U << move.leg;
    } else {
      went = go(
          model, [&](double part) { return walker.at(part); }, passage.part(phase), passage.part(move.phase), way);
      phase = move.phase;
    }
    if (!went) {
      fail(failure, "a leg cannot follow its way");
      return std::nullopt;
    }
    out.least_margin = std::min(out.least_margin, margin(setting, passage, equilibrium, moved, -1, phase));
    now = way.back();
  }
  // The last point is the second posture to the last bit, not but for rounding.
  if (!out.phases.empty()) out.phases.back().way.back() = to.at;
  return out;
}

}  // namespace foothold::octopod

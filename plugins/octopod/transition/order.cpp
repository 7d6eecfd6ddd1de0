// Search over (legs moved, phase): fewest moves left first, each state once.
#include "octopod/transition/order.hpp"

#include <algorithm>
#include <bit>

namespace foothold::octopod {
namespace {

constexpr double kSway = 0.004;      // m, around the centre of mass at every phase, wherever bodies move
constexpr double kSlack = 0.0005;    // m, for what a motion's straight pieces leave of the way
constexpr int kMostAttempts = 1500;  // of 503 orders on the ramps none takes more; where there is none it ends the search
constexpr unsigned kAll = (1U << kLegs) - 1;

class Order {
 public:
  Order(Passage& passage, contact::Equilibrium& equilibrium) : passage_(passage), equilibrium_(equilibrium) {}

  std::optional<std::vector<Move>> find(TransitionFailure* failure) {
    if (failure != nullptr) tell_hopeless(*failure);
    if (hopeless() >= 0) return std::nullopt;
    heads_.fill(kNone);
    push(0, 0, kNone);
    const int most = kLegs + passage_.phases();
    for (int left = most; left <= most;) {
      const std::uint16_t state = heads_[static_cast<std::size_t>(left)];
      if (state == kNone) {
        ++left;
        continue;
      }
      const unsigned moved = moved_of(state);
      const int phase = phase_of(state);
      if (moved == kAll && phase == passage_.phases()) return moves_to(state);
      if (left < best_) best_ = left, farthest_ = state;
      if (++attempts_ > kMostAttempts) break;
      // One move at a time: most states are left by their first move that works.
      if (tried_[state] == kMoves)
        heads_[static_cast<std::size_t>(left)] = next_[state];
      else
        left += attempt(moved, phase, tried_[state]++, state);
    }
    if (failure != nullptr) tell_stuck(*failure);
    return std::nullopt;
  }

 private:
  static constexpr int kPhases = Passage::kMostPhases + 1;
  static constexpr std::uint16_t kNone = 0xFFFF;
  static constexpr std::size_t kStates = 256 * kPhases;
  static constexpr int kMoves = kLegs + 2;

  static std::uint16_t state_of(unsigned moved, int phase) {
    return static_cast<std::uint16_t>(moved * kPhases + static_cast<unsigned>(phase));
  }
  static unsigned moved_of(std::uint16_t state) { return state / kPhases; }
  static int phase_of(std::uint16_t state) { return state % kPhases; }
  int left_of(unsigned moved, int phase) const { return kLegs - std::popcount(moved) + passage_.phases() - phase; }

  void push(unsigned moved, int phase, std::uint16_t from) {
    const std::uint16_t state = state_of(moved, phase);
    seen_[moved] |= 1U << phase;
    from_[state] = from;
    const auto left = static_cast<std::size_t>(left_of(moved, phase));
    tried_[state] = 0;
    next_[state] = heads_[left];
    heads_[left] = state;
  }
  bool seen(unsigned moved, int phase) const { return (seen_[moved] >> phase & 1U) != 0; }

  // Makes move number `move` if it can be made: 0 to 7 a leg, 8 the bodies forwards, 9 back. Returns by how much that changes the
  // moves left.
  int attempt(unsigned moved, int phase, int move, std::uint16_t state) {
    if (move < kLegs) {
      const unsigned after = moved | 1U << move;
      if (after == moved || seen(after, phase) || !passage_.holds(move, true, phase) || !may_lift(moved, phase, move)) return 0;
      push(after, phase, state);
      return -1;
    }
    const int next = move == kLegs ? phase + 1 : phase - 1;
    if (next < 0 || next > passage_.phases() || seen(moved, next)) return 0;
    if (!bodies_may_go(moved, std::min(phase, next)) || !stands(moved, phase) || !stands(moved, next)) return 0;
    push(moved, next, state);
    return next > phase ? -1 : 0;
  }

  bool bodies_may_go(unsigned moved, int phase) {
    for (int leg = 0; leg < kLegs; ++leg)
      if (!passage_.holds(leg, (moved >> leg & 1U) != 0, phase) || !passage_.holds(leg, (moved >> leg & 1U) != 0, phase + 1))
        return false;
    if (!passage_.bodies_clear(phase)) return false;
    for (int leg = 0; leg < kLegs; ++leg)
      if (!passage_.holds_on(leg, (moved >> leg & 1U) != 0, phase)) return false;
    for (int leg = 0; leg < kLegs; ++leg)
      for (int other = leg + 1; other < kLegs; ++other)
        if (!passage_.apart_on(leg, (moved >> leg & 1U) != 0, other, (moved >> other & 1U) != 0, phase)) return false;
    return passage_.sway(moved, phase) + kSlack <= kSway;
  }

  // The feet hold the robot wherever its centre of mass is within a square of 2 * aside round `at`.
  bool hold(const Stance& feet, const Vector3d& at, double aside) {
    const double mu = passage_.setting().options.friction;
    for (const double x : {-aside, aside})
      for (const double y : {-aside, aside})
        if (!equilibrium_.judge(feet.span(), at + Vector3d(x, y, 0), mu).stable) return false;
    return true;
  }

  bool stands(unsigned moved, int phase) {
    const std::uint32_t bit = 1U << phase;
    if ((asked_[moved] & bit) == 0) {
      asked_[moved] |= bit;
      if (hold(stance(passage_, moved, -1), passage_.centre_of_mass(moved, phase), kSway)) stand_[moved] |= bit;
    }
    return (stand_[moved] & bit) != 0;
  }

  // A leg that stands where `leg` would swing; -1: none. Precondition: it can swing there.
  int in_the_way(unsigned moved, int phase, int leg) {
    for (int other = 0; other < kLegs; ++other)
      if (other != leg && !passage_.swing_apart(leg, phase, other, (moved >> other & 1U) != 0)) return other;
    return -1;
  }

  bool may_lift(unsigned moved, int phase, int leg) {
    const std::optional<Swing>& swing = passage_.swing(leg, phase);
    if (!swing || in_the_way(moved, phase, leg) >= 0) return false;
    const Vector3d before = passage_.centre_of_mass(moved, phase), after = passage_.centre_of_mass(moved | 1U << leg, phase);
    const Vector3d middle = (swing->points[0] + swing->points[3]) / 2;
    double foot_spread = 0.0;
    for (const Vector3d& point : swing->points) foot_spread = std::max(foot_spread, (point - middle).head<2>().norm());
    const double aside = passage_.knee_weight() * swing->knee_spread + passage_.foot_weight() * foot_spread + kSlack;
    return hold(stance(passage_, moved, leg), (before + after) / 2, aside);
  }

  // A leg whose old foothold is lost before the new one is in reach, wherever the bodies are; -1: none.
  int hopeless() const {
    for (int leg = 0; leg < kLegs; ++leg) {
      bool some = false;
      for (int k = 0; k <= passage_.phases(); ++k) some |= passage_.holds(leg, false, k) && passage_.holds(leg, true, k);
      if (!some || !passage_.holds(leg, false, 0) || !passage_.holds(leg, true, passage_.phases())) return leg;
    }
    return -1;
  }
  void tell_hopeless(TransitionFailure& failure) const {
    failure.leg = hopeless();
    if (failure.leg >= 0) failure.because = "leg " + limb(failure.leg) + " nowhere reaches both its old and its new foothold";
  }
  void tell_stuck(TransitionFailure& failure) {
    const unsigned moved = moved_of(farthest_);
    const int phase = phase_of(farthest_);
    failure = {-1, "the bodies cannot move on"};
    for (int leg = 0; leg < kLegs; ++leg) {
      if ((moved >> leg & 1U) != 0) continue;
      failure.leg = leg;
      if (!passage_.holds(leg, true, phase))
        failure.because = "leg " + limb(leg) + "'s new foothold is out of reach where the bodies can go";
      else if (!passage_.swing(leg, phase))
        failure.because = "leg " + limb(leg) + " cannot swing clear of the ground and the bodies";
      else if (const int other = in_the_way(moved, phase, leg); other >= 0)
        failure.because = "leg " + limb(leg) + " cannot swing past leg " + limb(other);
      else
        failure.because = "no equilibrium without leg " + limb(leg);
      return;
    }
  }

  std::vector<Move> moves_to(std::uint16_t state) const {
    std::vector<Move> out;
    for (; from_[state] != kNone; state = from_[state]) {
      const unsigned lifted = moved_of(state) ^ moved_of(from_[state]);
      out.push_back({lifted == 0 ? -1 : std::countr_zero(lifted), phase_of(state)});
    }
    std::reverse(out.begin(), out.end());
    return out;
  }

  Passage& passage_;
  contact::Equilibrium& equilibrium_;
  std::array<std::uint32_t, 256> seen_{}, asked_{}, stand_{};  // by legs moved; bits are phases
  std::array<std::uint16_t, kLegs + kPhases> heads_{};         // by moves left: states to look at, last found first
  std::array<std::uint16_t, kStates> next_, from_;             // of states seen
  std::array<std::uint8_t, kStates> tried_;                    // moves tried
  std::uint16_t farthest_ = 0;
  int best_ = 1000, attempts_ = 0;
};

}  // namespace

Stance stance(const Passage& passage, unsigned moved, int lifted) {
  Stance out;
  for (int leg = 0; leg < kLegs; ++leg) {
    if (leg == lifted) continue;
    const Footing& foot = passage.footing(leg, (moved >> leg & 1U) != 0);
    out.contacts[out.count++] = {foot.point, foot.normal};
  }
  return out;
}

std::optional<std::vector<Move>> find_order(Passage& passage, contact::Equilibrium& equilibrium, TransitionFailure* failure) {
  return Order(passage, equilibrium).find(failure);
}

}  // namespace foothold::octopod

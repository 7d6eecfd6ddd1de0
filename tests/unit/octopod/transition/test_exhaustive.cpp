// Orders against all orders: every (legs moved, place of the bodies) on a fine grid, with equilibrium by another method and reach
// by the joints alone. That search bounds nothing between its states, so it finds an order wherever there is one; ours must find
// nothing where it finds none, and little less where it finds some.
#include <gtest/gtest.h>

#include <bit>
#include <deque>

#include "contact/projection.hpp"
#include "grounds.hpp"
#include "octopod/posture/pair.hpp"
#include "octopod/transition/transition.hpp"

namespace foothold::octopod {
namespace {

constexpr int kPlaces = 12;

class AllOrders {
 public:
  AllOrders(const Standing& from, const Standing& to, double friction) : from_(from), to_(to), friction_(friction) {}

  bool find() {
    std::array<std::array<bool, kPlaces + 1>, 256> seen{};
    std::deque<std::pair<unsigned, int>> open{{0U, 0}};
    seen[0][0] = true;
    while (!open.empty()) {
      const auto [moved, place] = open.back();
      open.pop_back();
      if (moved == 255U && place == kPlaces) return true;
      const auto visit = [&](unsigned next, int at) {
        if (seen[next][static_cast<std::size_t>(at)]) return;
        seen[next][static_cast<std::size_t>(at)] = true;
        open.emplace_back(next, at);
      };
      for (int leg = 0; leg < kLegs; ++leg) {
        const unsigned after = moved | 1U << leg;
        if (after != moved && holds(moved, place, leg) && holds(after, place, leg)) visit(after, place);
      }
      for (const int at : {place - 1, place + 1})
        if (at >= 0 && at <= kPlaces && holds(moved, at, -1)) visit(moved, at);
    }
    return false;
  }

 private:
  const Footing& footing(unsigned moved, int leg) const {
    return ((moved >> leg & 1U) != 0 ? to_ : from_).feet[static_cast<std::size_t>(leg)];
  }

  bool holds(unsigned moved, int place, int lifted) const {
    const double part = static_cast<double>(place) / kPlaces;
    const Pair a = pair_of(octopod(), from_.at), b = pair_of(octopod(), to_.at);
    Pair pair;
    pair.joint = a.joint + part * (b.joint - a.joint);
    for (std::size_t m = 0; m < 2; ++m)
      pair.turn[m] = Eigen::Quaterniond(a.turn[m]).slerp(part, Eigen::Quaterniond(b.turn[m])).toRotationMatrix();
    std::array<Vector3d, kLegs> feet;
    std::vector<contact::Contact> contacts;
    for (int leg = 0; leg < kLegs; ++leg) {
      const Footing& foot = footing(moved, leg);
      feet[static_cast<std::size_t>(leg)] = foot.point;
      if (leg != lifted) contacts.push_back({foot.point, foot.normal});
    }
    const std::optional<Coordinates> at = reaching(octopod(), pair, feet);
    return at &&
           contact::judge_by_projection(contacts, centre_of_mass(octopod(), *at), friction_, contact::FrictionCone::pyramid(10))
               .stable;
  }

  const Standing &from_, &to_;
  double friction_;
};

TEST(OctopodTransition, FindsAnOrderWhereAllOrdersTogetherHoldOneAndNoneWhereTheyHoldNone) {
  std::mt19937_64 random(31);
  int both = 0, neither = 0, missed = 0;
  const auto level = level_ground(), slope = slope_ground(0.36, 0.5), rough = bumpy_ground(0.03, 6);
  for (const TestGround* ground : {level.get(), slope.get(), rough.get()})
    for (int i = 0; i < 8; ++i) {
      const auto stand_at = [&](double x, double y, int heading) {
        const auto under = ground->surface.beneath({x, y, 5});
        return stand(octopod(), ground->surface, under->point, ground->terrain.normals[static_cast<std::size_t>(under->triangle)],
                     heading, 0.0);
      };
      const double x = uniform(random, -0.5, 0.5), y = uniform(random, -0.5, 0.5), angle = uniform(random, -3.14, 3.14);
      const double far = i % 2 == 0 ? uniform(random, 0.03, 0.1) : uniform(random, 0.15, 0.3);
      const int heading = static_cast<int>(random() % kOrientations);
      const Built from = stand_at(x, y, heading), to = stand_at(x + far * std::cos(angle), y + far * std::sin(angle), heading);
      if (from.hindrance != Hindrance::kNone || to.hindrance != Hindrance::kNone) continue;
      const double friction = i % 3 == 0 ? 0.37 : 0.4;
      const bool ours = has_transition(octopod(), ground->surface, {.friction = friction}, from.standing, to.standing);
      const bool all = AllOrders(from.standing, to.standing, friction).find();
      EXPECT_TRUE(all || !ours) << "an order where there is none";
      both += all && ours;
      neither += !all && !ours;
      missed += all && !ours;
    }
  EXPECT_GE(both, 8);
  EXPECT_GE(neither, 4);
  EXPECT_LE(missed, both / 2);
}

}  // namespace
}  // namespace foothold::octopod

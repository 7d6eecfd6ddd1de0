// Ways of several pieces, judged together and piece by piece.
#include <gtest/gtest.h>

#include "fixtures.hpp"
#include "hyrecro/motion/clear_way.hpp"

namespace foothold::hyrecro {
namespace {

TEST(ClearWay, OfSeveralPiecesIsFreeExactlyIfEachPieceIs) {
  const truss::Truss truss = testing::plane_with_plate(0.3, 0.1, 0.8, 0.15, 0.02);
  const Obstacles obstacles(truss);
  const Model& model = testing::shipped_model();
  const Surroundings around{model, obstacles, Isometry3d::Identity(), 0.005, {}};
  std::mt19937_64 random(31);
  const auto posture = [&] {
    Actuators q;
    for (int i = 0; i < 8; ++i)
      q[i] = testing::uniform(random, model.mechanism.shortest() + (i < 4 ? 0.03 : 0.0),
                              model.mechanism.longest() - (i < 4 ? 0.0 : 0.03));
    for (int i = 8; i < 10; ++i) q[i] = testing::uniform(random, -1.5, 1.5);
    return q;
  };
  int free = 0, blocked = 0;
  while (free < 40 || blocked < 40) {
    const Actuators first = posture();
    std::vector<Actuators> way{first};
    for (int i = 0; i < 3; ++i) way.push_back(way.back() + 0.3 * (posture() - way.back()));
    bool each = true;
    for (std::size_t i = 1; i < way.size(); ++i) each = each && !judge_way(around, way[i - 1], way[i]);
    const Blocked together = judge_way(around, way);
    ASSERT_EQ(!together, each) << together.what;
    ++(each ? free : blocked);
    ASSERT_LT(free + blocked, 20000);
  }
}

}  // namespace
}  // namespace foothold::hyrecro

// Motions: what Judge certifies holds at every sampled instant, and it certifies nearly all that keeps twice the margins.
#include <gtest/gtest.h>

#include <cstdlib>

#include "reference.hpp"

namespace foothold::bioloid {
namespace {

using namespace testing;

struct Motion {
  Joints a, b;
  Support support;
};

// The least room of any instant among `samples` + 1; stops at the first below 0.
double least_room(const Motion& m, const Demands& demands, int samples, const std::vector<Prism>& prisms) {
  double least = 1e9;
  for (int k = 0; k <= samples && least >= 0.0; ++k) {
    const double t = static_cast<double>(k) / samples;
    least = std::min(least, room(figures(shipped_model(), m.a + t * (m.b - m.a), m.support, prisms), demands, m.support.both));
  }
  return least;
}

// Far more than what is asked for.
Demands twice(Demands d) {
  d.clearance *= 2.0;
  d.balance *= 2.0;
  d.ground = -5e-4;
  d.slip *= 0.5;
  return d;
}

struct Count {
  int certified = 0, refused = 0, easy = 0, timid = 0;
};

template <class Next>
Count hold(int count, const Demands& demands, const std::vector<Prism>& prisms, Next&& next) {
  if (std::getenv("FOOTHOLD_LONG")) count *= 10;
  Judge judge(shipped_model(), demands, prisms);
  Count out;
  for (int i = 0; i < count; ++i) {
    const Motion m = next(i);
    const bool good = judge.motion(m.a, m.b, m.support) == Fault::kNone;
    (good ? out.certified : out.refused) += 1;
    if (good) {
      EXPECT_GE(least_room(m, demands, 100, prisms), -1e-9) << i;
    }
    if (least_room(m, twice(demands), 30, prisms) < 0.0) continue;
    ++out.easy;
    out.timid += !good;
  }
  std::printf("certified %d, refused %d; with twice the margins %d, of these refused %d\n", out.certified, out.refused, out.easy,
              out.timid);
  return out;
}

Side side_of(int i) { return i % 2 ? Side::kLeft : Side::kRight; }

TEST(BioloidMotions, WhatIsCertifiedInSingleSupportHoldsAllTheWay) {
  Draw draw{std::mt19937_64(5)};
  const Count c = hold(900, {}, {}, [&](int i) {
    Support support;
    support.foot = side_of(i);
    const double wild = 0.03 * (i % 6);
    return Motion{walking(shipped_model(), support.foot, draw, wild), walking(shipped_model(), support.foot, draw, wild), support};
  });
  EXPECT_GT(c.certified, 150);
  EXPECT_GT(c.refused, 150);
  EXPECT_GT(c.easy, 100);
  EXPECT_LE(c.timid, c.easy / 50);
}

TEST(BioloidMotions, WhatIsCertifiedInDoubleSupportNeitherSlipsNorTips) {
  Draw draw{std::mt19937_64(6)};
  const Count c = hold(500, {}, {}, [&](int i) {
    Motion m;
    m.support.foot = side_of(i);
    m.support.both = true;
    const double side = m.support.foot == Side::kRight ? 1.0 : -1.0;
    for (;;) {
      m.support.second = pose(draw(-0.05, 0.05), side * draw(0.075, 0.1), 0.0, 0.2 * draw(-1, 1));
      const double x = draw(-0.01, 0.03) + 0.5 * m.support.second.translation().x(), y = side * draw(-0.005, 0.08),
                   z = draw(0.185, 0.2);
      // From what linear joints follow within the slip to far more.
      const double far = 0.003 * std::pow(10.0, draw(0.0, 1.2));
      const Isometry3d from = pose(x, y, z, 0.1 * draw(-1, 1), 0.05 * draw(-1, 1), 0.05 * draw(-1, 1));
      const Isometry3d to = from * pose(far * draw(-1, 1), far * draw(-1, 1), far * draw(-1, 1), 5.0 * far * draw(-1, 1));
      const auto a = standing(shipped_model(), m.support.foot, from, m.support.second);
      const auto b = standing(shipped_model(), m.support.foot, to, m.support.second);
      if (!a || !b) continue;
      m.a = *a;
      m.b = *b;
      return m;
    }
  });
  EXPECT_GT(c.certified, 150);
  EXPECT_GT(c.refused, 80);
  EXPECT_GT(c.easy, 100);
  EXPECT_LE(c.timid, c.easy / 50);
}

TEST(BioloidMotions, WhatIsCertifiedAmongObstaclesKeepsClearOfThem) {
  Draw draw{std::mt19937_64(7)};
  const auto rectangle = [](double x, double y, double length, double width, double height) {
    return Prism{"box", {{x, y}, {x + length, y}, {x + length, y + width}, {x, y + width}}, height};
  };
  // A sill before the feet, a post beside them.
  const std::vector<Prism> prisms{rectangle(0.06, -0.2, 0.012, 0.4, 0.008), rectangle(-0.08, 0.155, 0.03, 0.03, 0.3),
                                  rectangle(-0.08, -0.185, 0.03, 0.03, 0.3)};
  const Count c = hold(900, {}, prisms, [&](int i) {
    Motion m;
    m.support.foot = side_of(i);
    m.support.at = pose(draw(-0.02, 0.005), draw(-0.03, 0.03), 0.0, 0.1 * draw(-1, 1));
    m.a = walking(shipped_model(), m.support.foot, draw, 0.03);
    m.b = walking(shipped_model(), m.support.foot, draw, 0.03);
    return m;
  });
  EXPECT_GT(c.certified, 50);
  EXPECT_GT(c.refused, 150);
  EXPECT_GT(c.easy, 30);
  EXPECT_LE(c.timid, c.easy / 20);
}

TEST(BioloidMotions, ArmsThatMoveCountToo) {
  Draw draw{std::mt19937_64(8)};
  const Count c = hold(600, {}, {}, [&](int i) {
    Motion m;
    m.support.foot = side_of(i);
    m.a = walking(shipped_model(), m.support.foot, draw, 0.02);
    m.b = walking(shipped_model(), m.support.foot, draw, 0.02);
    for (int j = 0; j < 6; ++j) {
      m.a[j] += draw(-0.4, 0.4);
      m.b[j] += draw(-0.4, 0.4);
    }
    return m;
  });
  EXPECT_GT(c.certified, 50);
  EXPECT_GT(c.refused, 50);
  EXPECT_GT(c.easy, 30);
  EXPECT_LE(c.timid, c.easy / 20);
}

}  // namespace
}  // namespace foothold::bioloid

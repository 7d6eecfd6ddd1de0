// The quick answers against the distances; and at clearance 0, overlap and nothing else.
#include <gtest/gtest.h>

#include "pairs.hpp"

namespace foothold::collision {
namespace {

template <class A, class B>
void expect_agreement(const A& a, const B& b, Pairs& pairs) {
  const double is = distance(a, b);
  for (const double clearance : {0.005, pairs.uniform(0.0, 0.3), is + 2e-9, is - 2e-9, 0.9 * is, 1.1 * is}) {
    if (!(clearance > 0.0) || std::abs(is - clearance) <= 1e-9) continue;
    EXPECT_EQ(nearer(a, b, clearance), is < clearance) << "distance " << is << ", clearance " << clearance;
  }
  // Apart means not overlapping; what overlaps has no distance.
  if (nearer(a, b, 0.0)) {
    EXPECT_LE(is, 1e-9);
  }
}

class Nearer : public testing::TestWithParam<Kind> {};

TEST_P(Nearer, AgreesWithTheDistance) {
  Pairs pairs(GetParam(), 3);
  for (int k = 0; k < 20000; ++k) {
    const Capsule c = pairs.capsule(), d = pairs.capsule();
    const Box b = pairs.box(), e = pairs.box();
    const std::vector<Vector3d> vertices = pairs.polygon();
    const Patch p{vertices};
    expect_agreement(c, d, pairs);
    expect_agreement(c, b, pairs);
    expect_agreement(b, e, pairs);
    expect_agreement(c, p, pairs);
    expect_agreement(b, p, pairs);
  }
}

// A point sampled in one body that lies within the other by 1e-9 m proves an overlap.
TEST_P(Nearer, SeesEveryOverlapThatASamplingProves) {
  Pairs pairs(GetParam(), 4);
  const auto inside = [](const Box& box, const Vector3d& point) {
    return ((box.pose.inverse() * point).cwiseAbs() - box.half).maxCoeff() < -1e-9;
  };
  int seen = 0;
  for (int k = 0; k < 5000; ++k) {
    const Box b = pairs.box(), e = pairs.box();
    const Capsule c = pairs.capsule();
    const std::vector<Vector3d> vertices = pairs.polygon();
    bool boxes = false, capsule = false, patch = false;
    for (int sample = 0; sample < 60; ++sample) {
      const Vector3d unit(pairs.uniform(-1, 1), pairs.uniform(-1, 1), pairs.uniform(-1, 1));
      boxes = boxes || (e.half.minCoeff() > 1e-6 && inside(b, e.pose * Vector3d(0.999999 * unit.cwiseProduct(e.half))));
      capsule = capsule || (c.radius > 1e-6 && inside(b, c.a + pairs.uniform(0, 1) * (c.b - c.a)));
      const std::size_t corner = static_cast<std::size_t>(pairs.integer(1, static_cast<int>(vertices.size()) - 2));
      const double s = pairs.uniform(0.01, 0.98), t = pairs.uniform(0.01, 0.99 - s);
      patch = patch || inside(b, vertices[0] + s * (vertices[corner] - vertices[0]) + t * (vertices[corner + 1] - vertices[0]));
    }
    EXPECT_TRUE(!boxes || nearer(b, e, 0.0)) << k;
    EXPECT_TRUE(!capsule || nearer(c, b, 0.0)) << k;
    EXPECT_TRUE(!patch || nearer(b, Patch{vertices}, 0.0)) << k;
    seen += boxes + capsule + patch;
  }
  EXPECT_GT(seen, 500);
}

INSTANTIATE_TEST_SUITE_P(Kinds, Nearer, testing::ValuesIn(kKinds));

}  // namespace
}  // namespace foothold::collision

// Adapted postures and unstable ones, frozen in MuJoCo: 1,000 with FOOTHOLD_LONG=1, else 120.
//
// The judge sees a rigid body on its feet, the slope's friction and gravity; whether it slides or tips it finds by itself.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <random>

#include "../slopes.hpp"
#include "hexpiderix/adapt/adapt.hpp"
#include "physics/frozen.hpp"

namespace foothold::hexpiderix::testing {
namespace {

constexpr double kBand = 0.12;         // of critical friction: so near to it soft contacts may creep, or hold a little longer
constexpr double kNearTipping = 1e-3;  // m of NESM: nearer to 0 than the contacts give way

int wanted() { return std::getenv("FOOTHOLD_LONG") != nullptr ? 1000 : 120; }

// As a rigid body: servos and brackets as points of their masses, and the thorax' own extent.
Vector3d inertia_of(const Model& model, const Coordinates& at, const Vector3d& com) {
  Vector3d out = Vector3d::Constant(model.thorax_mass * model.thorax_width * model.thorax_width / 12.0);
  const auto add = [&](double mass, const Vector3d& place) {
    const Vector3d from = place - com;
    out += mass * (Vector3d::Constant(from.squaredNorm()) - from.cwiseAbs2());
  };
  add(model.thorax_mass, at.thorax.translation());
  for (std::size_t leg = 0; leg < kLegs; ++leg) {
    const LegPoints points = leg_points(model, leg, at.legs[leg]);
    for (const Vector3d& servo : {points.coxa, points.hip, points.knee}) add(model.servo_mass, at.thorax * servo);
    add(model.femur_mass, at.thorax * (0.5 * (points.hip + points.knee)));
    add(model.tibia_mass, at.thorax * (0.5 * (points.knee + points.foot)));
  }
  return out;
}

physics::FrozenStance frozen(const Footholds& feet, const Evaluation& posture, double friction) {
  physics::FrozenStance out;
  for (std::size_t leg = 0; leg < kLegs; ++leg)
    if (feet.supports[leg]) out.contacts.push_back({feet.points[leg], feet.normals[leg]});
  out.centre_of_mass = posture.centre_of_mass;
  out.mass = shipped_model().mass();
  out.inertia = inertia_of(shipped_model(), posture.at, posture.centre_of_mass);
  out.friction = friction;
  return out;
}

struct Posed {
  Footholds feet;
  Evaluation posture;
};

// A posture on a random slope: adapted by one of the methods, or any that its legs allow.
std::optional<Posed> random_posture(std::mt19937_64& random) {
  const auto uniform = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
  const Legs sets[] = {kTriad1, kTriad2, Legs{0b111111}, Legs{0b110110}};
  Situation from = tilted(uniform(0, 60) * kDegree, uniform(0, 360) * kDegree, sets[random() % 4]);
  const auto kind = random() % 6;
  if (kind < 4) {
    AdaptOptions options;
    options.method = kind < 2 ? Method::kOptimal : kind == 2 ? Method::kChoice : Method::kGeometric;
    const Adaption found = adapt(shipped_model(), from, options, {});
    if (!found.evaluation.valid()) return std::nullopt;
    return Posed{found.footholds, found.evaluation};
  }
  from.thorax.translate(Vector3d(uniform(-0.06, 0.06), uniform(-0.06, 0.06), uniform(-0.06, 0.02)));
  from.thorax.rotate(Eigen::AngleAxisd(uniform(-0.4, 0.4), Vector3d::UnitY()));
  const Evaluation found = evaluate(shipped_model(), from.ground, from.footholds, from.thorax, {shipped_model().lift, true}, 0.0);
  if (!found.valid()) return std::nullopt;
  return Posed{from.footholds, found};
}

// How the judges agree: [ours: unstable, stable][near, far from critical][theirs: moves, stays].
struct Table {
  int counts[2][2][2] = {};

  void add(const Posed& posed, double needed, double friction) {
    const bool stable = posed.posture.nesm > 0.0 && friction >= needed;
    const bool far = std::abs(posed.posture.nesm) > kNearTipping && std::abs(friction / needed - 1.0) > kBand;
    const physics::Drift drift = physics::let_go(frozen(posed.feet, posed.posture, friction));
    ++counts[stable][far][!drift.moves()];
    if (far && stable != !drift.moves())
      ADD_FAILURE() << "we: " << (stable ? "stable" : "unstable") << "; it moves " << drift.way << " m, at last at " << drift.speed
                    << " m/s; NESM " << posed.posture.nesm << " m, needs friction " << needed << ", has " << friction;
  }

  void print() const {
    std::printf("                                          MuJoCo: moves  stays\n");
    for (const int ours : {1, 0})
      for (const int far : {1, 0})
        std::printf("we: %-8s  %-7s %.0f %% of critical friction %8d %6d\n", ours == 1 ? "stable" : "unstable",
                    far == 1 ? "outside" : "within", 100.0 * kBand, counts[ours][far][0], counts[ours][far][1]);
  }
};

// With friction from half to one and a half times what is needed, so both verdicts come near their border; where no friction is
// enough (the centre of mass is beside its feet), with any.
TEST(Physics, NoPostureThatWeCallStableMoves) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> share(0.5, 1.5);
  Table table;
  int judged = 0, tipping = 0;
  for (int tries = 0; tries < 10 * wanted() && judged < wanted(); ++tries) {
    const auto posed = random_posture(random);
    if (!posed) continue;
    const double critical = friction_needed(posed->feet, posed->posture.centre_of_mass);
    const bool tips = !std::isfinite(critical);
    const double friction = tips ? 2.0 * share(random) : std::max(0.02, critical * share(random));
    tipping += tips;
    table.add(*posed, critical, friction);
    ++judged;
  }
  table.print();
  EXPECT_EQ(judged, wanted());
  EXPECT_GT(table.counts[1][1][1], judged / 5);
  EXPECT_GT(table.counts[0][1][0], judged / 5);
  EXPECT_GT(tipping, judged / 50) << "some tip at any friction";
}

}  // namespace
}  // namespace foothold::hexpiderix::testing

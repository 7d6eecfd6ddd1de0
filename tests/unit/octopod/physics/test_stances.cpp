// Stances of planned routes and unstable ones, frozen in MuJoCo: 2,000 and 500 of them with FOOTHOLD_LONG=1, else 160 and 40.
#include <cstdio>
#include <cstdlib>
#include <set>

#include "contact/critical_friction.hpp"
#include "physics/frozen.hpp"
#include "planning.hpp"

namespace foothold::octopod {
namespace {

constexpr const char* kTerrains[] = {"terrain-ramps", "terrain-boulders", "terrain-stairs", "terrain-ditch"};
constexpr double kBand = 0.12;  // of critical friction: so near to it soft contacts may creep, or hold a little longer

struct Count {
  int stable = 160, unstable = 40;
};
Count wanted() { return std::getenv("FOOTHOLD_LONG") != nullptr ? Count{2000, 500} : Count{}; }

// As a rigid body: links and bodies as points of their masses, and the bodies' own extent.
Vector3d inertia_of(const Model& model, const Coordinates& at, const Vector3d& com) {
  Vector3d out = Vector3d::Zero();
  const auto add = [&](double mass, const Vector3d& place) {
    const Vector3d from = place - com;
    out += mass * (Vector3d::Constant(from.squaredNorm()) - from.cwiseAbs2());
  };
  for (const Isometry3d& module : modules(model, at)) {
    add(model.body_mass, module.translation());
    out += Vector3d::Constant(model.body_mass * model.body.squaredNorm() / 12.0);
  }
  for (int k = 0; k < kLegs; ++k) {
    const LegPoints points = leg(model, at, k);
    add(model.femur_mass, 0.5 * (points.shoulder + points.knee));
    add(model.tibia_mass, 0.5 * (points.knee + points.foot));
  }
  return out;
}

physics::FrozenStance frozen(const Standing& standing, double friction) {
  physics::FrozenStance out;
  for (const Footing& foot : standing.feet) out.contacts.push_back({foot.point, foot.normal});
  out.centre_of_mass = standing.centre_of_mass;
  out.mass = octopod().mass();
  out.inertia = inertia_of(octopod(), standing.at, standing.centre_of_mass);
  out.friction = friction;
  return out;
}

double needed_friction(const Standing& standing) {
  std::vector<contact::Contact> contacts;
  for (const Footing& foot : standing.feet) contacts.push_back({foot.point, foot.normal});
  return contact::critical_friction(contacts, standing.centre_of_mass);
}

// How the two judges agree: [ours: unstable, stable][near the critical friction, far from it][theirs: moves, stays].
struct Table {
  int counts[2][2][2] = {};

  void add(const Standing& standing, bool stable, double friction) {
    const double needed = needed_friction(standing), spare = friction / needed - 1.0;
    const bool far = std::abs(spare) > kBand;
    const physics::Drift drift = physics::let_go(frozen(standing, friction));
    ++counts[stable ? 1 : 0][far ? 1 : 0][drift.moves() ? 0 : 1];
    if (far && stable && drift.moves())
      ADD_FAILURE() << "a stable stance moves " << drift.way << " m; is at " << drift.speed << " m/s, and needs a friction of "
                    << needed;
  }

  void print() const {
    std::printf("                                        MuJoCo: moves  stays\n");
    for (const int ours : {1, 0})
      for (const int far : {1, 0})
        std::printf("we: %-8s  %s %.0f %% of critical friction %6d %6d\n", ours == 1 ? "stable" : "unstable",
                    far == 1 ? "outside" : "within ", 100.0 * kBand, counts[ours][far][0], counts[ours][far][1]);
  }
};

// The states that a plan between two random nodes goes through.
std::vector<State> planned_states(const Ground& ground, std::mt19937_64& random) {
  const auto node = [&] { return static_cast<int>(uniform(random, 0.0, ground.nodes() - 1e-9)); };
  const Request request = request_between(ground.place(node()), ground.place(node()));
  Collector out;
  try {
    shared_planner().plan(request, parameters(), ground, out);
  } catch (const InvalidRequest&) {
    return {};  // the robot cannot stand there
  }
  std::vector<State> states;
  for (const Step& step : out.steps)
    states.push_back(kOrientations * std::stoi(step.attributes[0].value) + std::stoi(step.attributes[1].value));
  return states;
}

TEST(Physics, NoStanceOfAPlanMoves) {
  const Count count = wanted();
  Table table;
  std::mt19937_64 random(11);
  for (const char* terrain : kTerrains) {
    const auto scene = shared_planner().prepare(shipped(terrain), parameters());
    const Ground& ground = dynamic_cast<const Ground&>(*scene);
    const double friction = ground.options().friction;
    std::set<State> judged;
    for (int tries = 0; tries < 2000 && static_cast<int>(judged.size()) < count.stable / 4; ++tries)
      for (const State state : planned_states(ground, random))
        if (static_cast<int>(judged.size()) < count.stable / 4 && judged.insert(state).second)
          table.add(ground.standing(state).standing, true, friction);
    EXPECT_EQ(static_cast<int>(judged.size()), count.stable / 4) << terrain;
  }
  // Unstable ones are rare on some terrains.
  const auto scene = shared_planner().prepare(shipped(kTerrains[0]), parameters());
  const Ground& ground = dynamic_cast<const Ground&>(*scene);
  std::vector<State> unstable;
  for (State state = 0; state < ground.states(); ++state)
    if (orientation_of(state) < kAxes && ground.stands(state) && !ground.stable(state)) unstable.push_back(state);
  std::shuffle(unstable.begin(), unstable.end(), random);
  EXPECT_GE(static_cast<int>(unstable.size()), count.unstable);
  unstable.resize(std::min(unstable.size(), static_cast<std::size_t>(count.unstable)));
  for (const State state : unstable) table.add(ground.standing(state).standing, false, ground.options().friction);
  table.print();
}

}  // namespace
}  // namespace foothold::octopod

// Stances of planned routes, unstable ones and instants of motions, frozen in MuJoCo: 2,000, 500 and 500 of them with
// FOOTHOLD_LONG=1, else 160, 40 and 60.
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

physics::FrozenStance frozen(const Coordinates& at, const std::vector<contact::Contact>& contacts, double friction) {
  physics::FrozenStance out;
  for (const contact::Contact& contact : contacts) out.contacts.push_back({contact.point, contact.normal});
  out.centre_of_mass = centre_of_mass(octopod(), at);
  out.mass = octopod().mass();
  out.inertia = inertia_of(octopod(), at, out.centre_of_mass);
  out.friction = friction;
  return out;
}

// How the two judges agree: [ours: unstable, stable][near the critical friction, far from it][theirs: moves, stays].
struct Table {
  int counts[2][2][2] = {};

  void add(const Standing& standing, bool stable, double friction) {
    std::vector<contact::Contact> contacts;
    for (const Footing& foot : standing.feet) contacts.push_back({foot.point, foot.normal});
    add(standing.at, contacts, stable, friction);
  }

  void add(const Coordinates& at, const std::vector<contact::Contact>& contacts, bool stable, double friction) {
    const double needed = contact::critical_friction(contacts, centre_of_mass(octopod(), at)), spare = friction / needed - 1.0;
    const bool far = std::abs(spare) > kBand;
    const physics::Drift drift = physics::let_go(frozen(at, contacts, friction));
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

// While one foot is in the air the others carry: 60 such instants of motions, 500 with FOOTHOLD_LONG=1.
TEST(Physics, NoInstantOfAMotionMoves) {
  const int wanted = std::getenv("FOOTHOLD_LONG") != nullptr ? 500 : 60;
  const Parameters values = parameters({{"transitions", "true"}});
  const auto scene = shared_planner().prepare(shipped("terrain-ditch"), values);
  const Request request = request_between({-1.5, -1.0, 0.0}, {0.5, 0.25, -0.05});
  Posture before = shared_planner().start(request, values, *scene);
  Collector out;
  ASSERT_EQ(shared_planner().plan(request, values, *scene, out).outcome, PlanReport::Outcome::kReached);
  Table table;
  std::size_t points = 0, seen = 0;
  for (const Step& step : out.steps) points += step.motion.size();
  const std::size_t every = std::max<std::size_t>(1, points / static_cast<std::size_t>(wanted));
  int on_seven = 0;
  for (const Step& step : out.steps) {
    for (const MotionPoint& point : step.motion) {
      if (seen++ % every != 0) continue;
      const Coordinates at = from_posture({point.base, point.joints, {}});
      std::vector<contact::Contact> contacts;
      for (std::size_t k = 0; k < kLegs; ++k) {
        const Vector3d foot = leg(octopod(), at, static_cast<int>(k)).foot;
        for (const Posture* posture : {static_cast<const Posture*>(&before), &step.after}) {
          const Isometry3d& frame = posture->stance[k].frame;
          if ((foot - frame.translation()).norm() > 1e-6) continue;
          contacts.push_back({frame.translation(), frame.linear().col(2)});
          break;
        }
      }
      on_seven += contacts.size() == 7 ? 1 : 0;
      table.add(at, contacts, true, values.real("friction"));
    }
    before = step.after;
  }
  EXPECT_GT(on_seven, wanted / 4);
  table.print();
}

}  // namespace
}  // namespace foothold::octopod

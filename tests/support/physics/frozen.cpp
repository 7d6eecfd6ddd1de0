// A frozen stance as a MuJoCo model, and its way under gravity.
#include "physics/frozen.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <string>

#include "physics/mujoco.hpp"

namespace foothold::physics {
namespace {

constexpr double kFoot = 0.01;             // m, radius of the spheres
constexpr double kTimeStep = 0.001;        // s, a quarter of the contacts' time constant: with half of it some stances creep
constexpr std::size_t kMostContacts = 31;  // bits of MuJoCo's contact filter

std::string model_xml(const FrozenStance& stance) {
  std::ostringstream out;
  out.precision(17);
  out << "<mujoco><compiler autolimits='true'/>"
      << "<option timestep='" << kTimeStep << "' " << kContactOptions << " solver='Newton' iterations='200' tolerance='1e-12'/>"
      << "<size nconmax='100' njmax='500'/>"
      << "<default><geom condim='3' priority='1' friction='" << stance.friction << " 0 0' " << kContactSolver << "/>"
      << "</default><worldbody>";
  for (std::size_t k = 0; k < stance.contacts.size(); ++k) {
    const FrozenContact& contact = stance.contacts[k];
    out << "<geom type='plane' size='1 1 1' pos='" << words(contact.point) << "' zaxis='" << words(contact.normal) << "' contype='"
        << (1u << k) << "' conaffinity='0'/>";
  }
  out << "<body pos='" << words(stance.centre_of_mass) << "'><freejoint/><inertial pos='0 0 0' mass='" << stance.mass
      << "' diaginertia='" << words(stance.inertia) << "'/>";
  for (std::size_t k = 0; k < stance.contacts.size(); ++k) {
    const FrozenContact& contact = stance.contacts[k];
    const Vector3d at = contact.point + kFoot * contact.normal - stance.centre_of_mass;
    out << "<geom type='sphere' size='" << kFoot << "' pos='" << words(at) << "' contype='0' conaffinity='" << (1u << k) << "'/>";
  }
  out << "</body></worldbody></mujoco>";
  return out.str();
}

// The centre of mass and the feet, which are the free body's geoms.
std::vector<Vector3d> places(const mjModel& model, const mjData& data) {
  std::vector<Vector3d> out{Vector3d(data.xipos[3], data.xipos[4], data.xipos[5])};
  for (int g = 0; g < model.ngeom; ++g)
    if (model.geom_bodyid[g] == 1) out.emplace_back(data.geom_xpos[3 * g], data.geom_xpos[3 * g + 1], data.geom_xpos[3 * g + 2]);
  return out;
}

double greatest_way(const std::vector<Vector3d>& from, const std::vector<Vector3d>& to) {
  double most = 0.0;
  for (std::size_t k = 0; k < from.size(); ++k) most = std::max(most, (to[k] - from[k]).norm());
  return most;
}

}  // namespace

Drift let_go(const FrozenStance& stance, const FrozenOptions& options) {
  if (stance.contacts.empty() || stance.contacts.size() > kMostContacts)
    throw std::runtime_error("a frozen stance has 1 to 31 contacts, not " + std::to_string(stance.contacts.size()));
  const OwnedModel model = compiled(model_xml(stance));
  const OwnedData data = state_of(*model);
  while (data->time < options.settling) mj_step(model.get(), data.get());
  mj_forward(model.get(), data.get());
  const std::vector<Vector3d> settled = places(*model, *data);
  std::vector<Vector3d> before = settled, now = settled;
  Drift drift;
  while (data->time < options.duration) {
    mj_step(model.get(), data.get());
    mj_kinematics(model.get(), data.get());
    before = std::move(now);
    now = places(*model, *data);
    drift.way = std::max(drift.way, greatest_way(settled, now));
  }
  drift.speed = greatest_way(before, now) / kTimeStep;
  return drift;
}

}  // namespace foothold::physics

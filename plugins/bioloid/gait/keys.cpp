// Key postures: the pelvis is moved until the centre of mass is where it belongs.
#include "bioloid/gait/keys.hpp"

namespace foothold::bioloid {
namespace {

constexpr double kClose = 1e-10;  // m
constexpr int kRounds = 40;

}  // namespace

double pelvis_height(const Model& model, double height) {
  return -model.sole(Side::kRight).z() + height - model.hip(Side::kRight).z();
}

PlanarPose beside(const Model& model, Side support) {
  const auto place = [&](Side side) { return (model.hip(side) + model.sole(side)).y(); };
  return {0.0, place(other(support)) - place(support), 0.0};
}

bool stand(const Model& model, Side support, const PlanarPose& pelvis, double pelvis_z, const PlanarPose& swing, double lift,
           Joints& joints) {
  const Isometry3d to_torso = to_world(pelvis, pelvis_z).inverse();
  return reach(model, support, to_torso, joints) && reach(model, other(support), to_torso * to_world(swing, lift), joints);
}

std::optional<KeyPosture> key_posture(const Model& model, Side support, const Key& key) {
  KeyPosture out;
  out.joints = model.carrying;
  const double z = pelvis_height(model, key.height);
  // The legs that stand carry about a fifth of the mass, half of which follows the pelvis; what follows is learned from each
  // round (Broyden, 1965).
  Eigen::Matrix2d follows = 0.75 * Eigen::Matrix2d::Identity();
  PlanarPose pelvis{key.balance.x(), key.balance.y(), key.heading};
  Eigen::Vector2d before = Eigen::Vector2d::Zero(), moved = Eigen::Vector2d::Zero();
  for (int round = 0; round < kRounds; ++round) {
    if (!stand(model, support, pelvis, z, key.swing, key.lift, out.joints)) return std::nullopt;
    const Eigen::Vector2d centre = (to_world(pelvis, z) * centre_of_mass(model, out.joints)).head<2>();
    const Eigen::Vector2d miss = key.balance - centre;
    if (miss.norm() < kClose) {
      out.pelvis = {pelvis.x, pelvis.y};
      return out;
    }
    if (round > 0) follows += (centre - before - follows * moved) * moved.transpose() / moved.squaredNorm();
    before = centre;
    moved = follows.inverse() * miss;
    pelvis.x += moved.x();
    pelvis.y += moved.y();
  }
  return std::nullopt;
}

}  // namespace foothold::bioloid

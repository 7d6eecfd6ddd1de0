// Key postures of a walk: both legs in closed form on the one walking branch, the pelvis level and placed so that the centre of
// mass lies where it is wanted. Postures of one branch can be joined; those of random restarts cannot. Metres and radians, in the
// supporting sole's frame. Any thread.
#pragma once

#include "bioloid/gait/planar.hpp"
#include "bioloid/model/kinematics.hpp"

namespace foothold::bioloid {

struct Key {
  PlanarPose swing;                                   // the other sole
  double lift = 0.0;                                  // of the other sole over the ground
  double heading = 0.0;                               // of the pelvis
  double height = 0.0;                                // of the hips over the ankles
  Eigen::Vector2d balance = Eigen::Vector2d::Zero();  // where the centre of mass shall project to, within 1e-10 m
};

struct KeyPosture {
  Joints joints;
  Eigen::Vector2d pelvis;  // where it came to lie
};

// Arms as in `model.carrying`. Empty if a leg does not reach; limits are the judge's business.
std::optional<KeyPosture> key_posture(const Model& model, Side support, const Key& key);

// Both legs for a given level pelvis, seen from the supporting sole. False if one does not reach. `pelvis_z`: of the torso's
// origin.
bool stand(const Model& model, Side support, const PlanarPose& pelvis, double pelvis_z, const PlanarPose& swing, double lift,
           Joints& joints);

// Of the torso's origin over the ground, when the hips are `height` over the ankles.
double pelvis_height(const Model& model, double height);

// Where the other sole stands beside the supporting one, when the robot stands with its feet parallel under its hips.
PlanarPose beside(const Model& model, Side support);

}  // namespace foothold::bioloid

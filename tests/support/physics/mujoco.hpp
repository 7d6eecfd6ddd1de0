// MuJoCo's objects with owners, and models from text. Inside the physics judges only: the header of the engine stays in their
// sources.
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <memory>
#include <string>

namespace foothold::physics {

struct Free {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
  void operator()(mjData* data) const { mj_deleteData(data); }
};
using OwnedModel = std::unique_ptr<mjModel, Free>;
using OwnedData = std::unique_ptr<mjData, Free>;

// Throws std::runtime_error with MuJoCo's message.
OwnedModel compiled(const std::string& xml);
OwnedData state_of(const mjModel& model);

// As XML takes it, with all digits.
std::string words(const Eigen::Vector3d& v);

// What every judge of ours lets contacts be: the elliptic cone (the pyramidal one calls unstable stances stable), stiff, and no
// slip within the cone.
inline constexpr char kContactOptions[] = "gravity='0 0 -9.80665' cone='elliptic' impratio='10' noslip_iterations='20'";
inline constexpr char kContactSolver[] = "solref='0.004 1' solimp='0.99 0.999 0.0001'";

}  // namespace foothold::physics

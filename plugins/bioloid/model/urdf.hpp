// Bioloid's model as URDF and from it: any biped of the same structure.
//
// The URDF has the 18 joints of kJointNames (revolute, with limits and velocity) in the structure of Model, whatever the links are
// called, and two fixed joints r_sole and l_sole under the feet, whose origins are the soles' centres, X to the toes. Other fixed
// joints join their link to the one that carries it. The root link is the torso. Links collide as boxes, parallel to the torso in
// the zero pose. What a URDF has no place for stands beside it in the robot's file: sole.size and carrying.*.
#pragma once

#include <string>

#include "bioloid/model/model.hpp"

namespace foothold::bioloid {

// Lengths and angles with all digits: reading it back gives the same model. Inertias are those of bodies as uniform boxes.
std::string write_urdf(const Model& model, const std::string& robot);

// Of `file.text("urdf")`. Throws InvalidModel that names the link or joint. Any thread.
Model read_urdf(const RobotModel& file);

}  // namespace foothold::bioloid

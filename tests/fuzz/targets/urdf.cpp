// URDF as Bioloid's model: what is taken can stand, and nothing in it is no number.
#include "../fuzzing.hpp"
#include "bioloid/model/model.hpp"
#include "foothold/errors.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace foothold;
  static const std::map<std::string, Quantity, std::less<>> kBeside{{"sole.size", {{0.18, 0.09}, "m", "assumed"}},
                                                                    {"carrying.shoulder_pitch", {{0.0}, "rad", "assumed"}},
                                                                    {"carrying.shoulder_roll", {{0.0}, "rad", "assumed"}},
                                                                    {"carrying.elbow", {{0.0}, "rad", "assumed"}}};
  try {
    const auto model = bioloid::Model::from_model(RobotModel(kBeside, {{"urdf", fuzz::text_of(data, size)}}));
    fuzz::demand(model.mass() > 0.0 && std::isfinite(model.mass()), "a robot has a mass");
    for (const bioloid::JointModel& joint : model.joints)
      fuzz::demand(joint.origin.allFinite() && joint.axis.allFinite() && joint.speed > 0.0 && !joint.limits.empty(),
                   "a joint can turn");
    for (const bioloid::Body& body : model.bodies) {
      fuzz::demand(body.centre_of_mass.allFinite(), "a centre of mass is somewhere");
      for (const bioloid::BodyBox& box : body.boxes)
        fuzz::demand(box.centre.allFinite() && box.half.minCoeff() > 0.0, "a box is somewhere and has edges");
    }
  } catch (const InvalidModel&) {
  }
  return 0;
}

// A model as URDF.
#include <sstream>

#include "bioloid/model/urdf.hpp"

namespace foothold::bioloid {
namespace {

std::string triple(const Vector3d& v) {
  std::ostringstream out;
  out.precision(17);
  out << v.x() << ' ' << v.y() << ' ' << v.z();
  return out.str();
}

class Writer {
 public:
  Writer(const Model& model, const std::string& robot) : model_(model) {
    out_.precision(17);
    out_ << "<?xml version=\"1.0\"?>\n<robot name=\"" << robot << "\">\n";
    for (const Body& body : model_.bodies) link(body);
    for (std::size_t j = 0; j < kJoints; ++j) joint(j);
    sole("r_sole", Side::kRight);
    sole("l_sole", Side::kLeft);
    out_ << "</robot>\n";
  }
  std::string text() const { return out_.str(); }

 private:
  void link(const Body& body) {
    out_ << "  <link name=\"" << body.name << "\">\n    <inertial>\n      <origin xyz=\"" << triple(body.centre_of_mass)
         << "\"/>\n      <mass value=\"" << body.mass << "\"/>\n";
    // A body without boxes is taken as a cube from its joint round its centre of mass.
    const Vector3d size =
        body.boxes.empty() ? Vector3d::Constant(2.0 * body.centre_of_mass.norm()) : Vector3d(2.0 * body.boxes[0].half);
    const Vector3d squares = size.cwiseAbs2() * body.mass / 12.0;
    out_ << "      <inertia ixx=\"" << squares.y() + squares.z() << "\" ixy=\"0\" ixz=\"0\" iyy=\"" << squares.x() + squares.z()
         << "\" iyz=\"0\" izz=\"" << squares.x() + squares.y() << "\"/>\n    </inertial>\n";
    for (const char* part : {"visual", "collision"})
      for (const BodyBox& box : body.boxes)
        out_ << "    <" << part << ">\n      <origin xyz=\"" << triple(box.centre) << "\"/>\n      <geometry><box size=\""
             << triple(2.0 * box.half) << "\"/></geometry>\n    </" << part << ">\n";
    out_ << "  </link>\n";
  }

  void joint(std::size_t j) {
    const JointModel& joint = model_.joints[j];
    begin(name_at(kJointNames, j), "revolute", static_cast<std::size_t>(joint.parent + 1), model_.bodies[j + 1].name, joint.origin);
    out_ << "    <axis xyz=\"" << triple(joint.axis) << "\"/>\n    <limit lower=\"" << joint.limits.low << "\" upper=\""
         << joint.limits.high << "\" effort=\"0\" velocity=\"" << joint.speed << "\"/>\n  </joint>\n";
  }

  void sole(const char* name, Side side) {
    out_ << "  <link name=\"" << name << "\"/>\n";
    begin(name, "fixed", leg_joint(side, 5) + 1, name, model_.sole(side));
    out_ << "  </joint>\n";
  }

  void begin(const std::string& name, const char* type, std::size_t parent, const std::string& child, const Vector3d& origin) {
    out_ << "  <joint name=\"" << name << "\" type=\"" << type << "\">\n    <parent link=\"" << model_.bodies[parent].name
         << "\"/>\n    <child link=\"" << child << "\"/>\n    <origin xyz=\"" << triple(origin) << "\"/>\n";
  }

  const Model& model_;
  std::ostringstream out_;
};

}  // namespace

std::string write_urdf(const Model& model, const std::string& robot) { return Writer(model, robot).text(); }

}  // namespace foothold::bioloid

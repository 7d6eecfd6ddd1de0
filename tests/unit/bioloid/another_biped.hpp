// A URDF that another hand might have written.
#pragma once

#include <sstream>
#include <string>

namespace foothold::bioloid::testing {

// A biped of other lengths in another's manner: frames turned, joints' origins anywhere on their axes, links joined by fixed
// joints.
inline std::string biped_by_hand() {
  std::ostringstream out;
  const auto link = [&](const std::string& name, double mass, const char* at, const char* size) {
    out << "<link name='" << name << "'><inertial><origin xyz='" << at << "'/><mass value='" << mass
        << "'/><inertia ixx='1' ixy='0' ixz='0' iyy='1' iyz='0' izz='1'/></inertial>";
    if (size) out << "<collision><origin xyz='" << at << "'/><geometry><box size='" << size << "'/></geometry></collision>";
    out << "</link>\n";
  };
  const auto joint = [&](const std::string& name, const std::string& parent, const std::string& child, const std::string& at,
                         const char* axis, const char* rpy = "0 0 0", const char* limits = "lower='-2.4' upper='2.4'") {
    const bool fixed = !axis;
    out << "<joint name='" << name << "' type='" << (fixed ? "fixed" : "revolute") << "'><parent link='" << parent
        << "'/><child link='" << child << "'/><origin xyz='" << at << "' rpy='" << rpy << "'/>";
    if (!fixed) out << "<axis xyz='" << axis << "'/><limit " << limits << " effort='1' velocity='6'/>";
    out << "</joint>\n";
  };
  out << "<robot name='other'>\n";
  link("trunk", 2.0, "0 0 0.15", "0.1 0.16 0.2");
  link("skull", 0.4, "0 0 0", "0.08 0.08 0.08");
  joint("neck", "trunk", "skull", "0.01 0 0.3", nullptr);
  for (const std::string side : {"r", "l"}) {
    const std::string s = side == "r" ? "-" : "", p = side + "_";
    const auto lateral = [&](const char* x, const char* y, const char* z) { return std::string(x) + " " + s + y + " " + z; };
    link(p + "clavicle", 0.05, "0 0 0", nullptr);
    link(p + "arm", 0.2, "0 0 -0.06", "0.04 0.04 0.1");
    link(p + "fore", 0.2, "0 0 -0.06", "0.04 0.04 0.1");
    joint(p + "shoulder_pitch", "trunk", p + "clavicle", lateral("0", "0.12", "0.22"), "0 1 0");
    joint(p + "shoulder_roll", p + "clavicle", p + "arm", lateral("0", "0.02", "0"), "1 0 0");
    joint(p + "elbow", p + "arm", p + "fore", "0 0 -0.13", "0 1 0");
    link(p + "yaw_link", 0.1, "0 0 -0.02", nullptr);
    link(p + "roll_link", 0.3, "0 0 0", "0.06 0.05 0.05");
    link(p + "femur", 0.5, "0 0 -0.1", "0.05 0.06 0.12");
    link(p + "tibia", 0.4, "0 0 -0.09", "0.05 0.05 0.1");
    link(p + "talus", 0.2, "0 0 0", "0.05 0.05 0.04");
    link(p + "plate", 0.2, "0.02 0 0", "0.18 0.09 0.01");
    out << "<link name='" << p << "sole_link'/>\n";
    // The yaw joint 50 mm above the hip; the roll joint behind it with its frame turned by a quarter about Z, so that the joint
    // turns about its own -Y; the knee beside the leg's plane on its axis.
    joint(p + "hip_yaw", "trunk", p + "yaw_link", lateral("0", "0.06", "0"), "0 0 -1");
    joint(p + "hip_roll", p + "yaw_link", p + "roll_link", "-0.03 0 -0.05", "0 -1 0", "0 0 1.5707963267948966");
    joint(p + "hip_pitch", p + "roll_link", p + "femur", "0 -0.03 0", "0 -1 0", "0 0 -1.5707963267948966");
    joint(p + "knee", p + "femur", p + "tibia", lateral("0.01", "0.025", "-0.2"), "0 1 0");
    joint(p + "ankle_pitch", p + "tibia", p + "talus", lateral("-0.005", "-0.025", "-0.19"), "0 1 0");
    joint(p + "ankle_roll", p + "talus", p + "plate", "0.04 0 0", "-1 0 0");
    joint(p + "sole", p + "plate", p + "sole_link", lateral("-0.02", "0.01", "-0.05"), nullptr);
  }
  out << "</robot>\n";
  auto text = out.str();
  for (auto at = text.find("--"); at != std::string::npos; at = text.find("--")) text.erase(at, 2);
  return text;
}

}  // namespace foothold::bioloid::testing

// Made-up plans that look like those of real robots: for the tests, and to look at (draw_samples).
#pragma once

#include "foothold/drawing/draw.hpp"

namespace foothold::drawing::samples {

msg::Pose pose(double x, double y, double z, double yaw = 0.0);
// A frame whose +Z is `normal` and whose +X is as near to `forward` as that allows.
msg::Pose pose_on(const std::array<double, 3>& at, const std::array<double, 3>& normal, const std::array<double, 3>& forward);
msg::Shape box(const std::string& name, double x, double y, double z, double sx, double sy, double sz);
msg::Shape sphere(const std::string& name, double x, double y, double z, double radius);
msg::Shape capsule(const std::string& name, const std::array<double, 3>& from, const std::array<double, 3>& to, double radius);
msg::Shape polygon(const std::string& name, const std::vector<std::array<double, 3>>& vertices);
msg::Contact contact(const std::string& limb, const msg::Pose& frame, const std::string& face = {});
msg::Step step(std::uint32_t index, const msg::Pose& base);

// Two bodies that slide past each other in the plane, round polygon obstacles, one of them concave.
Drawing planar();
// A biped climbing robot that goes from one beam to another; with `through` its last stance reaches through the second beam.
Drawing biped(bool through);
// A lattice tower of slanting bars, each drawn as its six faces, with one climber inside it.
Drawing tower();
// A hexapod on a terrain of triangles.
Drawing hexapod();

}  // namespace foothold::drawing::samples

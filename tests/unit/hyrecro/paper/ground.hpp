// Scenes for `method: paper`, and a judge of routes that shares nothing with the search but forward kinematics and distances.
#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include "hyrecro/paper/paper.hpp"

namespace foothold::hyrecro {

const Model& robot();
// 1 cm and 5 degrees; made once.
std::shared_ptr<const PlanarWorkspace> shared_workspace();
inline constexpr double kClearance = 0.005;  // m

std::unique_ptr<PreparedTruss> prepared(truss::Truss truss, double step = 0.05);
// `text` as a truss file.
std::unique_ptr<PreparedTruss> prepared(const std::string& text, double step = 0.05);
// config/scenes/<name>.yaml
std::unique_ptr<PreparedTruss> shipped(const std::string& name);

// By name; -1 if there is none.
int face_named(const PreparedTruss& scene, const std::string& name);
// A foothold by the world's position (m) and forward direction. The place must lie on a face with that normal.
Foothold stand(const PreparedTruss& scene, const Vector3d& at, const Vector3d& normal, const Vector3d& forward);

// Every stride: within limits, forward kinematics meet the foothold within 1e-6 m and rad, plate whole on its face, bodies
// `kClearance` from each other and from every solid. Reports as test failures.
void expect_stands(const PreparedTruss& scene, const Route& route);
// Changes of face along the route.
std::size_t transitions_of(const Route& route);

}  // namespace foothold::hyrecro

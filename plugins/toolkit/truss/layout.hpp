// What a truss file holds, before it becomes faces and solids.
#pragma once

#include <string>
#include <vector>

#include "truss/truss.hpp"

namespace foothold::truss {

// A bar of constant profile. Its axes: X from `from` to `to`, Z along `up` (what of it is perpendicular to X), Y = Z x X; width
// along Y, height along Z.
struct Beam {
  std::string name;
  Vector3d from = Vector3d::Zero(), to = Vector3d::Zero();  // m, of the axis
  double width = 0.0, height = 0.0;                         // m
  Vector3d up = Vector3d::UnitZ();
};

// A plane face without thickness.
struct Plate {
  std::string name;
  std::vector<Vector3d> polygon;  // m, in order, either direction
  Vector3d normal = Vector3d::UnitZ();
};

struct Layout {
  std::string description;
  std::vector<Beam> beams;
  std::vector<Plate> plates;
};

// Where `up` points if a beam says nothing: world Z, or world X for beams within 26 deg of the vertical.
Vector3d default_up(const Vector3d& along);

// The box of a beam. Precondition: as demanded of files.
Solid box_of(const Beam& beam);

// Faces and solids, with the covered parts cut out. Precondition: as demanded of files. Order: beams as given, each top, bottom,
// left, right, begin, end; then plates. Any thread.
Truss build(const Layout& layout);

// What parse_truss() builds. Throws InvalidScene as it does.
Layout parse_layout(const std::string& text);
// The file's text; parse_truss() of it gives build() of the same (numbers are written so that they read back exactly).
std::string to_yaml(const Layout& layout);

// Cuts what boxes cover out of `faces`; pieces are numbered from 1 (".1").
void cut_covered(std::vector<Face>& faces, const std::vector<Solid>& solids);

}  // namespace foothold::truss

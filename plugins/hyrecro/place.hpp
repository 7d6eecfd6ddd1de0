// A contact of a request on the truss: its face and its place there, or why it is none.
#pragma once

#include "hyrecro/scene/prepared.hpp"

namespace foothold::hyrecro {

// The foothold of `contact`, on the face that it names or on the one where it stands within `tolerance` (m and rad). `field` is
// the contact's path in the request. Throws InvalidRequest: no such face, off every face (with the distance to the nearest), tilted
// (with the angle), plate not fully on the face (by how much). Any thread.
Foothold place_of(const Model& model, const truss::Truss& truss, const Contact& contact, const std::string& field,
                  double tolerance);

// How far the plate reaches over the face's edges, m; 0: no corner does. Any thread.
double overhang(const Model& model, const truss::Face& face, const Foothold& foothold);

}  // namespace foothold::hyrecro

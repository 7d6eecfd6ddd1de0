// Does a plate lie wholly on its face?
#pragma once

#include "foothold/types.hpp"
#include "hyrecro/model/model.hpp"
#include "truss/truss.hpp"

namespace foothold::hyrecro {

// The contact's sole lies in the plane of the face that it names, its normal along the face's (1e-6 m, 1e-6 rad), and the whole
// plate within the outline and outside of the holes (1e-6 m). Returns the least distance between the plate and an edge of the face,
// m; negative by as much as it overhangs. Throws Refusal. Any thread.
double judge_on_face(const Model& model, const truss::Truss& truss, const Contact& contact);

// Signed distance between the rectangle [-half, half] and the segment p-q in its frame, m: negative by the greatest depth to which
// the segment enters it.
double signed_distance(const truss::Vector2d& half, const truss::Vector2d& p, const truss::Vector2d& q);

}  // namespace foothold::hyrecro

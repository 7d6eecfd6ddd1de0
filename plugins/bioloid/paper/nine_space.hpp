// A single support as a space of the paper's algorithms: nine free joints (posture/nine.hpp), a tenth coordinate for the heading
// where the robot turns; valid by the search's judge. Radians.
//
// Holds references: model and judge outlive the space. Used by one thread at a time, as the judge is.
#pragma once

#include "bioloid/paper/trials.hpp"
#include "bioloid/posture/judge.hpp"
#include "bioloid/posture/nine.hpp"

namespace foothold::bioloid::paper {

struct NineOptions {
  double step = 0.29 * 0.017453292519943295;  // rad, of every coordinate: one count of the robot's servos
  // Movements are certified between their points (Judge::motion). False: points only are judged, as in the paper, and holes are
  // jumped.
  bool certified = true;
  double equal = 1e-4;  // m, between positions of the swing sole that the last trimming takes for equal
};

// From `a` to `b`: nine coordinates if the swing sole has one heading in both, else ten. Limits of the tenth: the two headings.
Space nine_space(const Model& model, Judge& judge, const Support& support, const Joints& a, const Joints& b,
                 const NineOptions& options = {});
// A posture as a point of a space of `dimension` 9 or 10.
Point nine_point(const Model& model, Side support, const Joints& joints, int dimension);
// All joints of a point; `heading` of the swing sole where the point has none of its own. False as couple().
bool joints_at(const Model& model, Side support, const Point& point, double heading, Joints& joints);

// The paper's error (its Figure 15) of a point; heading as above.
Error balance_error(const Model& model, Judge& judge, const Support& support, double heading);

}  // namespace foothold::bioloid::paper

// One view of a plan: scene, robot, crossings, footholds, base, start and goal, in this order from back to front.
#pragma once

#include <vector>

#include "crossings.hpp"
#include "plan.hpp"
#include "svg.hpp"
#include "visibility.hpp"

namespace foothold::drawing {

// A picture's part that shows the plan from one side.
struct Panel {
  std::string caption;
  Projection projection;
  Rectangle area;
  bool above = false;
};

// Which colour each body of the robot has: one each for up to kRobotHues names, else one for all.
class Hues {
 public:
  explicit Hues(const Plan& plan);
  int of(const std::string& body) const;
  const std::vector<std::string>& names() const { return names_; }  // empty: one colour for all

 private:
  std::vector<std::string> names_;
};

// What one view is drawn with.
struct Canvas {
  Svg& svg;
  const Projection& projection;
  const Rectangle& area;
  const Occluders& occluders;
};

// The scene's faces that can be seen, in no order.
std::vector<SeenFace> scene_faces(const Plan& plan, const Projection& projection, const Rectangle& area);
void draw_scene(const Canvas& canvas, const Plan& plan, std::vector<SeenFace> faces);
// The robot at each stance: its bodies, or lines from base to contacts if the steps bear no shapes.
void draw_robot(const Canvas& canvas, const Plan& plan, const Hues& hues);
void draw_crossings(const Canvas& canvas, const std::vector<Crossing>& crossings);
// The base's way, start, goal, and every foothold with its frame and its step's number; a step that places many feet has one
// number, at its base, and their normals.
void draw_marks(const Canvas& canvas, const Plan& plan);

// A line whose hidden stretches have the class `d` too.
void draw_line(const Canvas& canvas, const std::string& classes, const Vector3d& from, const Vector3d& to);
inline bool places_many(const Stance& stance) { return stance.placed.size() > 3; }
// Every point of the base's way, from the start on.
Points base_way(const Plan& plan);
// Footholds that hold at the first stance and were placed by none of the drawn steps.
std::vector<Foothold> held_before(const Plan& plan);

}  // namespace foothold::drawing

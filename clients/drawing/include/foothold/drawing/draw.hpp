// A plan as a picture: the scene, the footholds with their frames, the robot's bodies at each stance, the way of its base, start
// and goal, from above and obliquely, as one SVG. It knows no robot: everything comes from the messages.
//
//   foothold::drawing::Drawing plan;
//   plan.robot = "xrobin";
//   plan.scene = running_event.scene();
//   plan.steps = steps;                    // with shapes, if the request asked for them
//   plan.summary = final_event.summary();
//   std::ofstream("plan.svg") << foothold::drawing::draw_svg(plan, {});
//
// Pure functions of their arguments: any thread, no files, the same bytes for the same input.
#pragma once

#include <foothold.h>

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace foothold::drawing {

// What is drawn. Everything but one step, shape or placement may be missing; what is missing is left out of the picture.
struct Drawing {
  std::string robot;                    // which model, for the title; empty: the summary's
  msg::State state = msg::UNKNOWN;      // UNKNOWN: not said in the title
  msg::Placement start;                 // of the request
  msg::Placement goal;                  // of the request
  std::vector<msg::Shape> scene;        // from the event RUNNING
  std::vector<msg::Step> steps;         // by index, rising
  std::optional<msg::Summary> summary;  // from the final event
  msg::Error error;                     // from the final event; code 0: none
};

enum class Views { kBoth, kAbove, kOblique };

// What the picture is fitted to. With kPlan the border may cut the scene off, which the caption then says.
enum class Frame { kScene, kPlan };

struct DrawOptions {
  Views views = Views::kBoth;
  Frame frame = Frame::kScene;
  std::optional<std::uint32_t> first_step;  // by Step.index, included
  std::optional<std::uint32_t> last_step;   // by Step.index, included
  double width = 1400.0;                    // px, 300 to 20000
  double height = 0.0;                      // px, 300 to 20000; 0: as the content needs
  double azimuth = -60.0;                   // deg, of the oblique view's eye, from +X towards +Y
  double elevation = 30.0;                  // deg, of that eye above the horizon, -90 to 90
};

// The picture cannot be drawn. `field` is a path such as "steps[3].base.position.x", "scene[12].vertices", "options.width", or
// empty when there is nothing to draw at all.
class InvalidDrawing : public std::runtime_error {
 public:
  InvalidDrawing(std::string field, const std::string& reason)
      : std::runtime_error(field.empty() ? reason : field + ": " + reason), field_(std::move(field)) {}
  const std::string& field() const noexcept { return field_; }

 private:
  std::string field_;
};

// The picture as a complete SVG document (UTF-8). Throws InvalidDrawing: no step, shape or placement at all, none among the chosen
// steps, a number that is not finite or beyond 1e9, a quaternion that is not of unit length within 1e-3, a size below 0, a polygon
// that is not planar or crosses itself, an option out of its range.
std::string draw_svg(const Drawing& drawing, const DrawOptions& options);

}  // namespace foothold::drawing

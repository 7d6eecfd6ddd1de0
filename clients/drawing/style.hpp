// Colours and strokes: one style sheet for light paper, and the same classes in dark for viewers that ask for it. The colours are
// those of Okabe and Ito (2008), which people of every colour vision tell apart; nothing is said by colour alone.
//
//   p paper   i ink (text)   q quiet ink   g grid   il ql lines in ink
//   f0..f15 a scene's face by brightness; n: without its outline   e an outline of the scene; m: of a mesh
//   r0..r3 a body of the robot; s0..s3 its brightness; h the outline of what is hidden of it
//   ax ay az axes of a frame; tx ty tz their letters   w the base's way; wp its points   d what is hidden of either
//   x where a body cuts the scene; xf xh its stripes; xl xm seen edge-on   S start   G goal   k label; kl the line to what it names
//   sk base to contacts   halo paper under a line   t b c l o fonts
#pragma once

#include <string>

namespace foothold::drawing {

inline constexpr int kRobotHues = 4;
inline constexpr int kRobotShades = 4;

// A <style> element, and the pattern that its class x fills with.
std::string style_sheet();
// "r1" for a body of this hue.
std::string hue_class(int hue);
// "r1 s3" for a body of this hue whose face has this brightness (0 to kShades - 1).
std::string robot_class(int hue, int shade);
// Of the robot at the stance with this place among all drawn: from faint to strong.
double stance_opacity(std::size_t place, std::size_t count);

}  // namespace foothold::drawing

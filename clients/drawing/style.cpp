// The two palettes and the rules that use them.
#include "style.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "solids.hpp"
#include "svg.hpp"

namespace foothold::drawing {
namespace {

using Colour = std::array<int, 3>;

struct Palette {
  Colour paper, ink, quiet, grid, scene_dark, scene_light, scene_edge, robot_dark, robot_light;
  Colour x, y, z, way, crossing, crossing_edge;
};

constexpr std::array<Colour, kRobotHues> kHues{
    {{86, 180, 233}, {230, 159, 0}, {204, 121, 167}, {240, 228, 66}}};  // sky blue, orange, purple, yellow

constexpr Palette kLight{.paper = {255, 255, 255},
                         .ink = {24, 24, 24},
                         .quiet = {96, 96, 96},
                         .grid = {226, 226, 226},
                         .scene_dark = {112, 108, 100},
                         .scene_light = {246, 244, 238},
                         .scene_edge = {92, 88, 80},
                         .robot_dark = {0, 0, 0},
                         .robot_light = {255, 255, 255},
                         .x = {213, 94, 0},
                         .y = {0, 138, 100},
                         .z = {0, 94, 158},
                         .way = {140, 50, 120},
                         .crossing = {255, 96, 32},
                         .crossing_edge = {0, 0, 0}};

constexpr Palette kDark{.paper = {20, 23, 26},
                        .ink = {236, 236, 236},
                        .quiet = {160, 164, 168},
                        .grid = {44, 49, 54},
                        .scene_dark = {36, 40, 44},
                        .scene_light = {132, 136, 140},
                        .scene_edge = {168, 172, 176},
                        .robot_dark = {0, 0, 0},
                        .robot_light = {255, 255, 255},
                        .x = {255, 140, 60},
                        .y = {40, 200, 150},
                        .z = {90, 170, 255},
                        .way = {226, 150, 210},
                        .crossing = {240, 70, 20},
                        .crossing_edge = {255, 255, 255}};

Colour mixed(const Colour& a, const Colour& b, double share_of_b) {
  Colour c{};
  for (std::size_t i = 0; i < 3; ++i) c[i] = static_cast<int>(std::lround(a[i] + (b[i] - a[i]) * share_of_b));
  return c;
}

std::string hex(const Colour& c) {
  std::array<char, 8> buffer;
  std::snprintf(buffer.data(), buffer.size(), "#%02x%02x%02x", static_cast<unsigned>(c[0]) & 0xFFU,
                static_cast<unsigned>(c[1]) & 0xFFU, static_cast<unsigned>(c[2]) & 0xFFU);
  return buffer.data();
}

std::string colours(const Palette& p) {
  std::string css;
  const auto rule = [&](const std::string& selector, const std::string& body) { css += selector + "{" + body + "}\n"; };
  const auto fill = [](const Colour& c) { return "fill:" + hex(c); };
  const auto stroke = [](const Colour& c) { return "stroke:" + hex(c); };
  rule(".p", fill(p.paper));
  rule(".i", fill(p.ink));
  rule(".q", fill(p.quiet));
  rule(".g", stroke(p.grid));
  rule(".il", stroke(p.ink));
  rule(".ql", stroke(p.quiet));
  for (int k = 0; k < kShades; ++k) {
    const Colour c = mixed(p.scene_dark, p.scene_light, k / (kShades - 1.0));
    rule(".f" + std::to_string(k), fill(c));
    rule(".n.f" + std::to_string(k), stroke(c));
  }
  rule(".e,.f", stroke(p.scene_edge));
  for (int hue = 0; hue < kRobotHues; ++hue) {
    const Colour base = kHues[static_cast<std::size_t>(hue)];
    const std::string name = hue_class(hue);
    rule("." + name, stroke(mixed(base, p.ink, 0.7)));
    rule(".h." + name, stroke(mixed(base, p.ink, 0.5)));
    for (int k = 0; k < kRobotShades; ++k) {
      const double light = -0.35 + 0.55 * k / (kRobotShades - 1.0);
      rule("." + name + ".s" + std::to_string(k),
           fill(light < 0 ? mixed(base, p.robot_dark, -light) : mixed(base, p.robot_light, light)));
    }
  }
  rule(".ax", stroke(p.x));
  rule(".ay", stroke(p.y));
  rule(".az", stroke(p.z));
  rule(".tx", fill(p.x));
  rule(".ty", fill(p.y));
  rule(".tz", fill(p.z));
  rule(".w", stroke(p.way));
  rule(".wp", fill(p.way));
  rule(".x", stroke(p.crossing_edge));
  rule(".xf", fill(p.crossing));
  rule(".xh", stroke(p.crossing_edge));
  rule(".xl", stroke(p.crossing_edge));
  rule(".xm", stroke(p.crossing));
  rule(".S,.G", stroke(p.ink) + ";" + fill(p.paper));
  rule(".k", fill(p.paper) + ";" + stroke(p.ink));
  rule(".kl", stroke(p.quiet));
  rule(".halo", stroke(p.paper));
  return css;
}

}  // namespace

std::string style_sheet() {
  std::string css = "<style>\n";
  css +=
      "text{font-family:'DejaVu Sans',Verdana,Arial,sans-serif;font-size:12px}\n"
      ".b{font-weight:bold}.t{font-size:17px;font-weight:bold}.l{font-size:11px}.c{font-size:12px}\n"
      "path,line,circle,rect{stroke-linejoin:round;stroke-linecap:round}\n"
      ".g{fill:none;stroke-width:.8}.il,.ql{fill:none;stroke-width:1}\n"
      ".f{stroke-width:.8}.n{stroke-width:.5}.e{fill:none;stroke-width:.8}.m path{stroke-width:.3}\n"
      ".r0,.r1,.r2,.r3{stroke-width:.9}.h{fill:none;stroke-dasharray:4 3;stroke-width:1}.sk{fill:none;stroke-width:2.5}\n"
      ".ax,.ay,.az{fill:none;stroke-width:2}.d{stroke-dasharray:2.5 2.5;stroke-linecap:butt;stroke-width:1.4}\n"
      ".w{fill:none;stroke-width:1.8}.w.d{stroke-dasharray:5 4}\n"
      ".x{fill:url(#cut);stroke-width:1.8}.xh{fill:none;stroke-width:1.6}.xl{fill:none;stroke-width:6}.xm{fill:none;stroke-width:4;"
      "stroke-dasharray:4 4;stroke-linecap:butt}.S,.G{stroke-width:1.6}.G{"
      "fill-opacity:.0}.S{fill-"
      "opacity:.0}\n"
      ".k{stroke-width:.8;fill-opacity:.8}.k.d{stroke-dasharray:2.5 2;stroke-width:.8}.kl{stroke-width:.6}.o{font-size:9px}\n"
      ".halo{fill:none;stroke-width:4;stroke-opacity:.7}\n";
  css += colours(kLight);
  // Striped, so that it stands out in grey too.
  const std::string stripes =
      "<pattern id='cut' width='6' height='6' patternUnits='userSpaceOnUse' patternTransform='rotate(45)'>"
      "<rect class='xf' width='6' height='6'/><path class='xh' d='M0 0V6'/></pattern>\n";
  css += "@media screen and (prefers-color-scheme:dark){\n" + colours(kDark) + "}\n</style>\n" + stripes;
  return css;
}

std::string hue_class(int hue) {
  std::string name(1, 'r');
  return name.append(std::to_string(hue));
}

std::string robot_class(int hue, int shade) {
  const int level = shade * (kRobotShades - 1) / (kShades - 1);
  return hue_class(hue).append(" s").append(std::to_string(level));
}

double stance_opacity(std::size_t place, std::size_t count) {
  constexpr double kStrongest = 0.9;
  if (count < 2) return kStrongest;
  // The more stances there are the more of them lie over each other: then only the later ones are strong.
  const double many = std::clamp(static_cast<double>(count - 2) / 16.0, 0.0, 1.0);
  const double faintest = 0.2 - 0.13 * many;
  const double age = static_cast<double>(place) / static_cast<double>(count - 1);
  return faintest + (kStrongest - faintest) * std::pow(age, 1.0 + 2.0 * many);
}

}  // namespace foothold::drawing

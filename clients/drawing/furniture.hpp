// What stands round the views: captions, rulers, scale bar, axes.
#pragma once

#include "view.hpp"

namespace foothold::drawing {

// The least length of 1, 2 or 5 times a power of ten that is not below `least`. m
double round_length(double least);

// Millimetres for small plans, metres for others.
struct LengthUnit {
  const char* name;
  double per_metre;
};
LengthUnit unit_for(double reach);

// A box along the world's axes, m.
struct WorldBox {
  Vector3d low = Vector3d::Zero(), high = Vector3d::Zero();
};

// Lines at round coordinates, under everything: all over the view from above; in the oblique one under `box`, on its bottom.
void draw_grid(Svg& svg, const Panel& panel, const WorldBox& box);
// Border, caption (which says so if the scene is `cut_off` by the border), scale bar, the world's axes and, in the view from above,
// coordinates along the border.
void draw_panel_frame(Svg& svg, const Panel& panel, LengthUnit unit, bool cut_off);

}  // namespace foothold::drawing

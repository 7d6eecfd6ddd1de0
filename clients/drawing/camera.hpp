// The two views: parallel projections of the world onto pixels.
#pragma once

#include "polygon.hpp"

namespace foothold::drawing {

// Unit vectors in the world: right and up on the picture, and from the picture towards the viewer.
struct Camera {
  Vector3d right, up, towards;
};

// World +X to the right, +Y up the page.
Camera camera_above();
// Eye in the direction `azimuth` (deg, from +X towards +Y), `elevation` (deg) above the horizon; world +Z up the page.
Camera camera_oblique(double azimuth, double elevation);

// px, y downwards
struct Rectangle {
  double left = 0.0, top = 0.0, width = 0.0, height = 0.0;
  double right() const { return left + width; }
  double bottom() const { return top + height; }
  bool holds(const Vector3d& p) const { return p.x() >= left && p.x() <= right() && p.y() >= top && p.y() <= bottom(); }
};

// World (m) to screen (px right, px down, px towards the viewer).
struct Projection {
  Camera camera;
  Vector3d centre = Vector3d::Zero();  // m; the point that comes to lie at `middle`
  Vector2d middle = Vector2d::Zero();  // px
  double scale = 1.0;                  // px per m

  Vector3d operator()(const Vector3d& p) const {
    const Vector3d from = p - centre;
    return {middle.x() + scale * camera.right.dot(from), middle.y() - scale * camera.up.dot(from),
            scale * camera.towards.dot(from)};
  }
  Points operator()(const Points& points) const {
    Points seen;
    seen.reserve(points.size());
    for (const Vector3d& p : points) seen.push_back((*this)(p));
    return seen;
  }
};

// How far points reach on a camera's picture, and the world point in the middle of that.
struct Reach {
  double width = 0.0, height = 0.0;  // m
  Vector3d centre = Vector3d::Zero();
};
Reach reach(const Camera& camera, const Points& points);

}  // namespace foothold::drawing

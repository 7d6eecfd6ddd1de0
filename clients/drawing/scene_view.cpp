// The scene: faces from back to front, and polygons seen edge-on as lines.
#include <algorithm>

#include "painter.hpp"
#include "view.hpp"

namespace foothold::drawing {
namespace {

constexpr std::size_t kMesh = 200;  // faces; with more the edges are drawn thin

bool off_panel(const Points& points, const Rectangle& area) {
  const Box2 box = flat_bounds(points);
  return !box.meets({{area.left, area.top}, {area.right(), area.bottom()}});
}

}  // namespace

std::vector<SeenFace> scene_faces(const Plan& plan, const Projection& projection, const Rectangle& area) {
  std::vector<SeenFace> all;
  for (std::size_t i = 0; i < plan.scene.size(); ++i)
    for (SeenFace& face : seen_faces(plan.scene[i], projection, i))
      if (!off_panel(face.points, area)) all.push_back(std::move(face));
  return all;
}

void draw_scene(const Canvas& canvas, const Plan& plan, std::vector<SeenFace> faces) {
  if (plan.scene.empty()) return;
  Svg& svg = canvas.svg;
  const bool mesh = faces.size() > kMesh;
  svg.open(mesh ? "g class='m'" : "g");
  for (const SeenFace& face : painters_order(std::move(faces))) {
    const std::string shade = std::to_string(face.shade);
    const bool whole = std::all_of(face.outline.begin(), face.outline.end(), [](bool edge) { return edge; });
    svg.path((whole ? "f f" : "n f") + shade, closed_path(face.points));
    if (whole) continue;
    std::string edges;
    for (std::size_t i = 0; i < face.points.size(); ++i)
      if (face.outline[i]) edges += open_path({face.points[i], face.points[(i + 1) % face.points.size()]});
    if (!edges.empty()) svg.path("e", edges);
  }
  for (const Body& body : plan.scene)
    for (const Points& piece : edge_on_pieces(body, canvas.projection)) {
      if (off_panel(piece, canvas.area)) continue;
      for (std::size_t i = 0; i < piece.size(); ++i) {
        const Vector3d &a = piece[i], &b = piece[(i + 1) % piece.size()];
        if ((b - a).head<2>().norm() < 1e-3) continue;  // it points at the viewer
        double from = 0.0;
        auto hidden = canvas.occluders.hidden(a, b);
        hidden.emplace_back(1.0, 1.0);
        for (const auto& [begin, end] : hidden) {
          if (begin > from) svg.line("e", a + (b - a) * from, a + (b - a) * begin);
          from = end;
        }
      }
    }
  svg.close("g");
}

}  // namespace foothold::drawing

// Where two faces meet.
#include "hyrecro/scene/face_pair.hpp"

#include <algorithm>
#include <cmath>

namespace foothold::hyrecro {
namespace {

constexpr double kParallel = 1e-3;  // sine of the angle between planes
constexpr double kOnLine = 1e-6;    // m: edges this near to the meeting line are on it

// Edges of face k on the meeting line within `window`, if they run along it in `direction` (+1, -1): stretches of t.
std::vector<Stretch> edges_on_line(const FacePair& pair, std::size_t k, double direction, const Stretch& window) {
  const truss::Face& face = *pair.faces[k]->face;
  const Eigen::Matrix3d into = face.frame.linear().transpose();
  const Vector2d at = (into * (pair.at - face.frame.translation())).head<2>();
  const Vector2d l = (into * pair.l).head<2>(), u = (into * pair.u[k]).head<2>();
  const double x0 = at.x() + window.begin * l.x(), x1 = at.x() + window.end * l.x();
  std::vector<Stretch> out;
  pair.faces[k]->edges.visit(std::min(x0, x1) - kOnLine, std::max(x0, x1) + kOnLine, [&](const FaceEdges::Edge& edge) {
    const Vector2d a = edge.a - at, b = edge.b - at;
    if (std::abs(a.dot(u)) > kOnLine || std::abs(b.dot(u)) > kOnLine || direction * (b - a).dot(l) <= 0.0) return;
    out.push_back({std::min(a.dot(l), b.dot(l)), std::max(a.dot(l), b.dot(l))});
  });
  return out;
}

}  // namespace

SeenFace::SeenFace(const truss::Face& of) : face(&of), edges(of), normal(of.frame.linear().col(2)) {
  const Eigen::AlignedBox2d& box = edges.bounds();
  const std::array<Vector2d, 4> flat{box.min(), {box.max().x(), box.min().y()}, box.max(), {box.min().x(), box.max().y()}};
  for (std::size_t c = 0; c < 4; ++c) {
    corner[c] = of.frame * Vector3d(flat[c].x(), flat[c].y(), 0.0);
    bounds.extend(corner[c]);
  }
}

std::optional<FacePair> meet(const SeenFace& a, const SeenFace& b, double apart) {
  const Vector3d cross = a.normal.cross(b.normal);
  const double sine = cross.norm();
  if (sine < kParallel) return std::nullopt;
  const double cosine = a.normal.dot(b.normal);
  FacePair pair;
  pair.faces = {&a, &b};
  pair.l = cross / sine;
  pair.u = {(b.normal - cosine * a.normal) / sine, (a.normal - cosine * b.normal) / sine};
  // From a's origin in a's plane straight to b's plane.
  const Vector3d& origin = a.face->frame.translation();
  pair.at = origin + b.normal.dot(b.face->frame.translation() - origin) / sine * pair.u[0];
  for (std::size_t k = 0; k < 2; ++k) {
    pair.along[k] = {INFINITY, -INFINITY};
    pair.off[k] = {INFINITY, -INFINITY};
    for (const Vector3d& corner : pair.faces[k]->corner) {
      const double t = pair.l.dot(corner - pair.at), off = pair.u[k].dot(corner - pair.at);
      pair.along[k] = {std::min(pair.along[k].begin, t), std::max(pair.along[k].end, t)};
      pair.off[k] = {std::min(pair.off[k][0], off), std::max(pair.off[k][1], off)};
    }
  }
  if (pair.along[0].begin > pair.along[1].end + apart || pair.along[1].begin > pair.along[0].end + apart) return std::nullopt;
  return pair;
}

std::vector<Stretch> convex_edge(const FacePair& pair) {
  const Stretch window{std::max(pair.along[0].begin, pair.along[1].begin), std::min(pair.along[0].end, pair.along[1].end)};
  for (const auto& off : pair.off)
    if (off[0] > kOnLine || off[1] < -kOnLine) return {};
  if (window.end - window.begin < kOnLine) return {};
  // Faces lie to the left of their edges, and both shall lie behind the other: along l on the first, against it on the second.
  const std::vector<Stretch> first = edges_on_line(pair, 0, 1.0, window);
  if (first.empty()) return {};
  std::vector<Stretch> shared;
  for (const Stretch& b : edges_on_line(pair, 1, -1.0, window))
    for (const Stretch& a : first) {
      const Stretch both{std::max(a.begin, b.begin), std::min(a.end, b.end)};
      if (both.end - both.begin > kOnLine) shared.push_back(both);
    }
  std::sort(shared.begin(), shared.end(), [](const Stretch& a, const Stretch& b) { return a.begin < b.begin; });
  return shared;
}

SoleLine sole_line(const Model& model, const FacePair& pair, std::size_t k, double distance, bool front, const Stretch& window) {
  const truss::Face& face = *pair.faces[k]->face;
  const Vector3d away = front ? pair.u[k] : Vector3d(-pair.u[k]);
  const Eigen::Matrix3d into = face.frame.linear().transpose();
  const Vector2d away2 = (into * away).head<2>();
  SoleLine line;
  line.along = (into * pair.l).head<2>();
  line.origin = (into * (pair.at + distance * away - face.frame.translation())).head<2>();
  line.heading = std::atan2(-away2.y(), -away2.x());
  const double half = 0.5 * model.plate.x();
  line.stretches = free_stretches(pair.faces[k]->edges, {line.origin, line.along, -half, half, 0.5 * model.plate.y()}, window);
  return line;
}

std::vector<Stretch> near_to(const std::vector<Stretch>& own, const std::vector<Stretch>& others, double apart) {
  std::vector<Stretch> out;
  std::size_t first = 0;
  for (const Stretch& stretch : own) {
    while (first < others.size() && others[first].end + apart < stretch.begin) ++first;
    const std::size_t before = out.size();
    for (std::size_t k = first; k < others.size() && others[k].begin - apart <= stretch.end; ++k) {
      const Stretch part{std::max(stretch.begin, others[k].begin - apart), std::min(stretch.end, others[k].end + apart)};
      if (part.begin > part.end) continue;
      if (out.size() > before && part.begin <= out.back().end)
        out.back().end = std::max(out.back().end, part.end);
      else
        out.push_back(part);
    }
  }
  return out;
}

}  // namespace foothold::hyrecro

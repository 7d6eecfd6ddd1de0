// Where two faces meet.
#include "hyrecro/scene/face_pair.hpp"

#include <algorithm>
#include <cmath>

namespace foothold::hyrecro {
namespace {

constexpr double kParallel = 1e-3;  // sine of the angle between planes
constexpr double kOnLine = 1e-6;    // m: edges this near to the meeting line are on it

// Outline edges on the meeting line that run along `direction`, so that the face lies to their left: stretches of t.
std::vector<Stretch> edges_on_line(const FacePair& pair, std::size_t k, const Vector3d& direction) {
  const SeenFace &own = *pair.faces[k], &other = *pair.faces[1 - k];
  std::vector<Stretch> out;
  const auto off = [&](const Vector3d& v) { return std::abs(other.normal.dot(v - pair.at)); };
  const auto ring = [&](const std::vector<Vector3d>& vertices) {
    for (std::size_t e = 0; e < vertices.size(); ++e) {
      const Vector3d &a = vertices[e], &b = vertices[(e + 1) % vertices.size()];
      if (off(a) > kOnLine || off(b) > kOnLine || (b - a).dot(direction) <= 0.0) continue;
      const double s = (a - pair.at).dot(pair.l), t = (b - pair.at).dot(pair.l);
      out.push_back({std::min(s, t), std::max(s, t)});
    }
  };
  ring(own.outline);
  for (const Polygon& hole : own.face->holes) {
    std::vector<Vector3d> vertices;
    for (const Vector2d& v : hole) vertices.push_back(own.face->frame * Vector3d(v.x(), v.y(), 0.0));
    ring(vertices);
  }
  return out;
}

}  // namespace

SeenFace seen(const truss::Face& face) {
  SeenFace out{&face, {}, face.frame.linear().col(2), {}};
  out.outline.reserve(face.outline.size());
  for (const Vector2d& v : face.outline) {
    out.outline.push_back(face.frame * Vector3d(v.x(), v.y(), 0.0));
    out.bounds.extend(out.outline.back());
  }
  return out;
}

std::optional<FacePair> meet(const SeenFace& a, const SeenFace& b) {
  const Vector3d cross = a.normal.cross(b.normal);
  const double sine = cross.norm();
  if (sine < kParallel) return std::nullopt;
  const double cosine = a.normal.dot(b.normal);
  FacePair pair{
      {&a, &b}, Vector3d::Zero(), cross / sine, {(b.normal - cosine * a.normal) / sine, (a.normal - cosine * b.normal) / sine}};
  // From a's origin in a's plane straight to b's plane.
  const Vector3d& origin = a.face->frame.translation();
  pair.at = origin + b.normal.dot(b.face->frame.translation() - origin) / sine * pair.u[0];
  return pair;
}

std::vector<Stretch> convex_edge(const FacePair& pair) {
  // Faces lie to the left of their edges, and both shall lie behind the other: along l on the first, against it on the second.
  const std::vector<Stretch> first = edges_on_line(pair, 0, pair.l);
  if (first.empty()) return {};
  std::vector<Stretch> shared;
  for (const Stretch& b : edges_on_line(pair, 1, -pair.l))
    for (const Stretch& a : first) {
      const Stretch both{std::max(a.begin, b.begin), std::min(a.end, b.end)};
      if (both.end - both.begin > kOnLine) shared.push_back(both);
    }
  std::sort(shared.begin(), shared.end(), [](const Stretch& a, const Stretch& b) { return a.begin < b.begin; });
  return shared;
}

bool concave_room(const FacePair& pair, std::size_t k, double distance, double half_plate) {
  double low = INFINITY, high = -INFINITY;
  for (const Vector3d& v : pair.faces[k]->outline) {
    const double off = pair.u[k].dot(v - pair.at);
    low = std::min(low, off);
    high = std::max(high, off);
  }
  return low <= distance - half_plate + 1e-9 && high >= distance + half_plate - 1e-9;
}

SoleLine sole_line(const Model& model, const FacePair& pair, std::size_t k, double distance, bool front) {
  const truss::Face& face = *pair.faces[k]->face;
  const Vector3d away = front ? pair.u[k] : Vector3d(-pair.u[k]);
  const Eigen::Matrix3d into = face.frame.linear().transpose();
  const Vector2d away2 = (into * away).head<2>();
  SoleLine line;
  line.along = (into * pair.l).head<2>();
  line.origin = (into * (pair.at + distance * away - face.frame.translation())).head<2>();
  line.heading = std::atan2(-away2.y(), -away2.x());
  const double half = 0.5 * model.plate.x();
  line.stretches = free_stretches(face, {line.origin, line.along, -half, half, 0.5 * model.plate.y()});
  return line;
}

std::vector<Stretch> near_to(const std::vector<Stretch>& own, const std::vector<Stretch>& others, double apart) {
  std::vector<Stretch> out;
  for (const Stretch& stretch : own) {
    std::vector<Stretch> parts;
    for (const Stretch& other : others) {
      const Stretch part{std::max(stretch.begin, other.begin - apart), std::min(stretch.end, other.end + apart)};
      if (part.begin > part.end) continue;
      if (!parts.empty() && part.begin <= parts.back().end)
        parts.back().end = std::max(parts.back().end, part.end);
      else
        parts.push_back(part);
    }
    out.insert(out.end(), parts.begin(), parts.end());
  }
  return out;
}

}  // namespace foothold::hyrecro

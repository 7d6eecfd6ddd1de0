// Ground: the fine triangles and their neighbours, made at once; postures and verdicts, made when asked for.
#include "octopod/search/ground.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <stdexcept>
#include <string>
#include <unordered_map>

#include "contact/critical_friction.hpp"
#include "contact/newton.hpp"
#include "octopod/search/neighbours.hpp"
#include "terrain/centroids.hpp"

namespace foothold::octopod {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

std::uint64_t pair_of(State from, State to) {
  return static_cast<std::uint64_t>(static_cast<std::uint32_t>(from)) << 32U | static_cast<std::uint32_t>(to);
}

// A node's axis, which two headings have in common.
std::size_t axis_of(State state) { return static_cast<std::size_t>(kAxes * node_of(state) + orientation_of(state) % kAxes); }

// The one of its two headings whose posture is made, not turned.
State first_of(State state) { return kOrientations * node_of(state) + orientation_of(state) % kAxes; }

const GroundOptions& checked(const GroundOptions& options) {
  if (!(options.friction >= 0.0))
    throw std::invalid_argument("friction must not be negative, is " + std::to_string(options.friction));
  if (options.neighbours < 1) throw std::invalid_argument("at least one neighbour, not " + std::to_string(options.neighbours));
  return options;
}

}  // namespace

struct Ground::Kept {
  Kept(const Model& robot, std::shared_ptr<const terrain::Surface> above, const GroundOptions& wanted)
      : model(robot),
        surface(std::move(above)),
        options(checked(wanted)),
        fine(terrain::subdivide(surface->terrain(), options.resolution, options.split)),
        tree(fine),
        judge(contact::FrictionCone{options.cone_edges}) {
    if (options.as_printed) {
      fine_surface.emplace(fine);
      newton.emplace(contact::NewtonSettings{.edges = options.cone_edges});
    }
    node_of_triangle.assign(fine.size(), -1);
    for (std::size_t t = 0; t < fine.size(); ++t)
      if (fine.ground[t] != 0) {
        node_of_triangle[t] = static_cast<int>(triangles.size());
        triangles.push_back(static_cast<int>(t));
      }
    neighbours = make_neighbours(fine, tree, triangles, node_of_triangle, options.neighbours);
    forget();
  }

  void forget() {
    built.clear();
    which.assign(triangles.size() * kOrientations, -1);
    verdicts.assign(triangles.size() * kAxes, Verdict::kUnasked);
    critical.assign(triangles.size() * kAxes, kUnknown);
    passages.clear();
  }

  std::vector<contact::Contact> contacts(const Standing& standing) const {
    std::vector<contact::Contact> out;
    for (const Footing& foot : standing.feet) out.push_back({foot.point, foot.normal});
    return out;
  }

  Built stand_at(const Vector3d& node, const Vector3d& normal, int axis) const {
    if (options.as_printed) return stand_paper(model, *fine_surface, tree, node, normal, axis, options.clearance);
    return stand(model, *surface, node, normal, axis, options.clearance);
  }

  bool holds(const Standing& standing) {
    if (options.as_printed) {
      std::mt19937_64 random(1);
      return newton->stable(contacts(standing), standing.centre_of_mass, options.friction, random);
    }
    // From nothing each time, so that an answer on the very border does not depend on what was asked before.
    judge.forget();
    return judge.judge(contacts(standing), standing.centre_of_mass, options.friction).stable;
  }

  std::size_t triangle(int node) const { return static_cast<std::size_t>(triangles[static_cast<std::size_t>(node)]); }

  enum class Verdict : std::uint8_t { kUnasked, kStable, kUnstable };

  Model model;
  std::shared_ptr<const terrain::Surface> surface;
  GroundOptions options;
  terrain::Terrain fine;
  terrain::CentroidTree tree;
  std::vector<int> triangles;         // by node
  std::vector<int> node_of_triangle;  // -1: an obstacle
  Neighbours neighbours;

  contact::Equilibrium judge;
  // As printed: the tree's own surface; Newton from random forces, which are the same for each question.
  std::optional<terrain::Surface> fine_surface;
  std::optional<contact::NewtonEquilibrium> newton;
  std::deque<Built> built;        // addresses stay
  std::vector<int> which;         // by state: its place in `built`; -1: not asked for
  std::vector<Verdict> verdicts;  // by node and axis: both headings of an axis have the same feet
  std::vector<double> critical;   // likewise
  std::unordered_map<std::uint64_t, bool> passages;
  long made = 0;
};

Ground::Ground(const Model& model, std::shared_ptr<const terrain::Surface> surface, const GroundOptions& options)
    : kept_(std::make_unique<Kept>(model, std::move(surface), options)) {}
Ground::~Ground() = default;

const Model& Ground::model() const { return kept_->model; }
const terrain::Surface& Ground::surface() const { return *kept_->surface; }
const GroundOptions& Ground::options() const { return kept_->options; }
int Ground::nodes() const { return static_cast<int>(kept_->triangles.size()); }
const Vector3d& Ground::place(int node) const { return kept_->fine.centroids[kept_->triangle(node)]; }
const Vector3d& Ground::normal(int node) const { return kept_->fine.normals[kept_->triangle(node)]; }
double Ground::slope(int node) const { return std::acos(std::clamp(normal(node).z(), -1.0, 1.0)); }
int Ground::nearest_node(const Vector3d& point) const {
  return kept_->node_of_triangle[static_cast<std::size_t>(kept_->tree.nearest(point, 1).front())];
}
std::span<const int> Ground::nearest(int node) const { return kept_->neighbours.nearest.of(node); }
std::span<const int> Ground::adjacent(int node) const { return kept_->neighbours.adjacent.of(node); }
std::span<const double> Ground::lengths(int node) const {
  const auto beside = adjacent(node);
  return std::span<const double>(kept_->neighbours.lengths)
      .subspan(static_cast<std::size_t>(beside.data() - kept_->neighbours.adjacent.all.data()), beside.size());
}
long Ground::postures_made() const { return kept_->made; }
void Ground::forget() const { kept_->forget(); }

const Built& Ground::standing(State state) const {
  Kept& kept = *kept_;
  if (const int known = kept.which[static_cast<std::size_t>(state)]; known >= 0) return kept.built[static_cast<std::size_t>(known)];
  const int node = node_of(state), heading = orientation_of(state);
  if (heading >= kAxes) {
    const Built& opposite = standing(state - kAxes);
    kept.built.push_back(turned(kept.model, opposite));
  } else {
    kept.built.push_back(kept.stand_at(place(node), normal(node), heading));
    ++kept.made;
  }
  kept.which[static_cast<std::size_t>(state)] = static_cast<int>(kept.built.size()) - 1;
  return kept.built.back();
}

bool Ground::stable(State state) const {
  Kept& kept = *kept_;
  Kept::Verdict& verdict = kept.verdicts[axis_of(state)];
  if (verdict == Kept::Verdict::kUnasked) {
    const Built& built = standing(first_of(state));
    bool holds = built.hindrance == Hindrance::kNone;
    if (holds) {
      holds = kept.holds(built.standing);
    }
    verdict = holds ? Kept::Verdict::kStable : Kept::Verdict::kUnstable;
  }
  return verdict == Kept::Verdict::kStable;
}

double Ground::critical_friction(State state) const {
  Kept& kept = *kept_;
  double& critical = kept.critical[axis_of(state)];
  if (std::isnan(critical)) {
    const Built& built = standing(first_of(state));
    critical = std::numeric_limits<double>::infinity();
    if (built.hindrance == Hindrance::kNone) {
      kept.judge.forget();
      critical = contact::critical_friction(kept.judge, kept.contacts(built.standing), built.standing.centre_of_mass).mu;
    }
  }
  return critical;
}

std::optional<bool> Ground::passage(State from, State to) const {
  const auto found = kept_->passages.find(pair_of(from, to));
  return found == kept_->passages.end() ? std::nullopt : std::optional(found->second);
}
void Ground::keep_passage(State from, State to, bool open) const { kept_->passages.insert_or_assign(pair_of(from, to), open); }

std::vector<Shape> Ground::shapes() const {
  const terrain::Terrain& coarse = kept_->surface->terrain();
  std::vector<Shape> out;
  for (std::size_t t = 0; t < coarse.size(); ++t) {
    Shape shape{Shape::Kind::kPolygon, "terrain " + std::to_string(t), Isometry3d::Identity(), Vector3d::Zero(), {}};
    for (int k = 0; k < 3; ++k) shape.vertices.push_back(coarse.corner(static_cast<int>(t), k));
    out.push_back(std::move(shape));
  }
  return out;
}

}  // namespace foothold::octopod

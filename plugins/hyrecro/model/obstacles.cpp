// A scene's solids behind a tree of bounds: one walk through the tree for the whole robot, then body by body.
#include <limits>
#include <span>
#include <vector>

#include "collision/bound_tree.hpp"
#include "hyrecro/model/bodies.hpp"

namespace foothold::hyrecro {

using collision::Bounds;
using collision::Box;
using collision::Capsule;
using collision::Patch;

struct Obstacles::Tree {
  struct Solid {
    Bounds bounds;
    Box box;                         // of a box
    std::vector<Vector3d> vertices;  // of a polygon, in the world; empty: a box
  };
  std::vector<Solid> solids;
  collision::BoundTree tree{{}};
};

namespace {

template <class Solid>
bool nearer(const Capsule& body, const Solid& solid, double clearance) {
  return solid.vertices.empty() ? collision::nearer(body, solid.box, clearance)
                                : collision::nearer(body, Patch{solid.vertices}, clearance);
}

template <class Solid>
bool nearer(const Box& body, const Solid& solid, double clearance) {
  return solid.vertices.empty() ? collision::nearer(body, solid.box, clearance)
                                : collision::nearer(body, Patch{solid.vertices}, clearance);
}

template <class Body, class Solid>
double distance(const Body& body, const Solid& solid) {
  return solid.vertices.empty() ? collision::distance(body, solid.box) : collision::distance(body, Patch{solid.vertices});
}

// Of one body: the nearest solid within `reach`, which shrinks to what is found.
template <class Tree, class Body>
void look(const Tree& tree, const Body& body, const char* name, double& reach, Obstacles::Nearest& out) {
  const Bounds bounds = bounds_of(body);
  tree.tree.visit(collision::grown(bounds, reach), [&](std::uint32_t k) {
    const auto& solid = tree.solids[k];
    if (solid.bounds.squaredExteriorDistance(bounds) > reach * reach) return true;
    const double found = distance(body, solid);
    if (found <= reach && found < out.distance) {
      out = {found, name, static_cast<int>(k)};
      reach = found;
    }
    return true;
  });
}

}  // namespace

Obstacles::Obstacles(const truss::Truss& truss) {
  auto tree = std::make_unique<Tree>();
  std::vector<Bounds> bounds;
  for (const truss::Solid& solid : truss.solids) {
    Tree::Solid out;
    if (solid.kind == truss::Solid::Kind::kBox) {
      out.box = {solid.pose, solid.half};
      out.bounds = collision::bounds_of(out.box);
    } else {
      for (const auto& vertex : solid.polygon) out.vertices.push_back(solid.pose * Vector3d(vertex.x(), vertex.y(), 0.0));
      out.bounds = collision::bounds_of(Patch{out.vertices});
    }
    bounds.push_back(out.bounds);
    tree->solids.push_back(std::move(out));
  }
  tree->tree = collision::BoundTree(bounds);
  tree_ = std::move(tree);
}

Obstacles::~Obstacles() = default;
Obstacles::Obstacles(Obstacles&&) noexcept = default;

bool Obstacles::free(const Bodies& bodies, double clearance) const {
  const std::array<Bounds, 2> leg{collision::grown(bounds_of(bodies.leg[0]), clearance),
                                  collision::grown(bounds_of(bodies.leg[1]), clearance)};
  const std::array<Bounds, 2> plate{bounds_of(bodies.plate[0]), bounds_of(bodies.plate[1])};
  const Bounds hip = collision::grown(bounds_of(bodies.hip), clearance);
  const Bounds all = hip.merged(leg[0]).merged(leg[1]).merged(plate[0]).merged(plate[1]);
  return tree_->tree.visit(all, [&](std::uint32_t k) {
    const Tree::Solid& solid = tree_->solids[k];
    for (std::size_t j = 0; j < 2; ++j)
      if (solid.bounds.intersects(leg[j]) && nearer(bodies.leg[j], solid, clearance)) return false;
    if (solid.bounds.intersects(hip) && nearer(bodies.hip, solid, clearance)) return false;
    for (std::size_t j = 0; j < 2; ++j)
      if (solid.bounds.intersects(plate[j]) && nearer(bodies.plate[j], solid, 0.0)) return false;
    return true;
  });
}

Obstacles::Nearest Obstacles::nearest(const Bodies& bodies, double reach) const {
  Nearest out{std::numeric_limits<double>::infinity(), "", -1};
  look(*tree_, bodies.leg[0], "leg 0", reach, out);
  look(*tree_, bodies.leg[1], "leg 1", reach, out);
  look(*tree_, bodies.hip, "hip", reach, out);
  return out;
}

Obstacles::Nearest Obstacles::nearest_of_plates(const Bodies& bodies, double reach) const {
  Nearest out{std::numeric_limits<double>::infinity(), "", -1};
  look(*tree_, bodies.plate[0], "plate 0", reach, out);
  look(*tree_, bodies.plate[1], "plate 1", reach, out);
  return out;
}

double Obstacles::distance(const Capsule& body, double reach) const {
  Nearest out{std::numeric_limits<double>::infinity(), "", -1};
  look(*tree_, body, "", reach, out);
  return out.distance;
}

double Obstacles::distance(const Box& body, double reach) const {
  Nearest out{std::numeric_limits<double>::infinity(), "", -1};
  look(*tree_, body, "", reach, out);
  return out.distance;
}

}  // namespace foothold::hyrecro

// HyReCRo's collision bodies in a posture, and whether they are free of each other and of a scene.
//
// Both plates (boxes, without their lowest layer, the model's `skin`), both legs (capsules) and the hip plate (box). Of the robot
// with itself these pairs are judged: leg-leg, plate-plate, each leg with the other foot's plate, both plates with the hip plate. A
// leg touches its own plate and the hip plate by construction.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>

#include "collision/distance.hpp"
#include "hyrecro/model/chain.hpp"
#include "truss/truss.hpp"

namespace foothold::hyrecro {

struct Bodies {
  std::array<collision::Box, 2> plate;
  std::array<collision::Capsule, 2> leg;
  collision::Box hip;
};

// In the world, if sole 0 stands at `sole0`. Any thread.
Bodies bodies_at(const Model& model, const Coordinates& coordinates, const Isometry3d& sole0);

// No two bodies of the robot are nearer than `clearance` (m).
bool free_of_itself(const Bodies& bodies, double clearance);
// Least distance between two bodies of the robot, m.
double self_distance(const Bodies& bodies);

// A scene's solids with a broad phase. Immutable after construction; any thread.
class Obstacles {
 public:
  explicit Obstacles(const truss::Truss& truss);
  ~Obstacles();
  Obstacles(Obstacles&&) noexcept;

  // Legs and hip stay `clearance` (m) away from every solid; plates must not overlap any (they touch what they hold on to).
  bool free(const Bodies& bodies, double clearance) const;
  struct Nearest {
    double distance = 0.0;  // m; infinite without solids
    std::string body;       // "leg A" by the order of `bodies`: "leg 0", "plate 1", "hip"
    int solid = -1;
  };
  // Of legs and hip: what comes nearest to a solid, looked for up to `reach` (m) away.
  Nearest nearest(const Bodies& bodies, double reach) const;
  // The same for both plates.
  Nearest nearest_of_plates(const Bodies& bodies, double reach) const;
  // Of one body alone, m: exact up to `reach` (m), infinite if no solid is so near. For proofs along a path, body by body.
  double distance(const collision::Capsule& body, double reach) const;
  double distance(const collision::Box& body, double reach) const;

 private:
  struct Tree;
  std::unique_ptr<const Tree> tree_;
};

}  // namespace foothold::hyrecro

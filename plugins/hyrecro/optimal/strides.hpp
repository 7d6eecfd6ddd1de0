// Whether one stride exists, and with what joints: closed form first, exact reachability where that finds nothing.
#pragma once

#include <memory>
#include <optional>

#include "hyrecro/optimal/bounds.hpp"
#include "hyrecro/optimal/level_postures.hpp"
#include "hyrecro/reach/by_poses.hpp"
#include "hyrecro/reach/reachability.hpp"
#include "hyrecro/scene/prepared.hpp"

namespace foothold::hyrecro {

// Borrows model and scene. Used by one thread at a time.
class Strides {
 public:
  Strides(const Model& model, const PreparedTruss& scene);

  // Before anything is asked: both feet must have room to rise by `lift` (m, 0: none) along their normals from where they stand,
  // without which no motion sets them down there or takes them away: proved by exact reachability, without the scene.
  void demand_room(double lift) { lift_ = lift; }
  double lift() const { return lift_; }

  const StrideBounds& bounds() const { return bounds_; }
  const Model& model() const { return model_; }
  const PreparedTruss& scene() const { return scene_; }

  // The free foot is put to `to` while the other holds at `from`: joints free of collisions with the scene and the robot itself.
  // Both on one face, closed form alone: what it misses may still exist.
  std::optional<Coordinates> level(const Foothold& from, const Foothold& to) const;
  // The same by exact reachability, on any faces: nothing means that there is none.
  std::optional<Coordinates> exact(const Foothold& from, const Foothold& to);
  // Reachable whatever the scene. `free_in_holding`: pose of the free sole seen from the other.
  std::optional<Coordinates> alone(const Isometry3d& free_in_holding);
  // The robot stands free of itself and of the scene, with room to rise.
  bool fits(const Coordinates& coordinates, const Isometry3d& holding) const;
  const LevelPostures& level_postures() const { return level_; }
  // The robot stands free of the scene.
  bool clear(const Coordinates& coordinates, const Isometry3d& holding) const;
  bool on_face(const Foothold& foothold) const;

 private:
  bool has_room(const Isometry3d& free_in_holding);

  const Model& model_;
  const PreparedTruss& scene_;
  double lift_ = 0.0;
  StrideBounds bounds_;
  LevelPostures level_;
  std::unique_ptr<Reachability> reachability_;
  ByPoses<std::optional<Coordinates>> in_scene_, alone_;
};

}  // namespace foothold::hyrecro

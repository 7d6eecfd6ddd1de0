// The ground that Bioloid walks on: level, with prisms on it. Immutable; any thread.
#pragma once

#include "bioloid/prism.hpp"
#include "foothold/planner.hpp"

namespace foothold::bioloid {

class Ground final : public PreparedScene {
 public:
  Ground() = default;  // free
  // A plane scene. Obstacles without a height are higher than the robot; concave ones are taken apart. Throws InvalidScene.
  explicit Ground(const std::string& path);

  const std::vector<Prism>& prisms() const { return prisms_; }
  // Walls and roofs.
  std::vector<Shape> shapes() const override;

 private:
  std::vector<Prism> prisms_;
  std::vector<Shape> shapes_;
};

}  // namespace foothold::bioloid

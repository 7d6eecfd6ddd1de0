// Right steps on a floor, made by hand: both legs' mechanisms bent against each other, so that the hip plate stays level.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <random>
#include <string>

#include "foothold/robot_file.hpp"
#include "hyrecro/check/check.hpp"

namespace foothold::hyrecro {

inline Model shipped_model() { return Model::from_model(load_robot_model(FOOTHOLD_CONFIG_DIR "/robots/hyrecro.yaml")); }

// A floor of 3 m x 3 m at z = 0, "floor/top", with a solid "floor" below.
truss::Truss floor_scene();
// A box among the solids, m.
void add_box(truss::Truss& truss, const std::string& name, const Vector3d& centre, const Vector3d& half);

// Level postures: each leg's hip lies `shift` (m, along the foot's X) beside its sole and `height` above its ankle pin.
struct Level {
  std::array<double, 2> shift{0.0, 0.0}, height{0.28, 0.28};
  std::array<double, 2> hip{0.0, 0.0};
};
Coordinates coordinates_of(const Model& model, const Level& level);
bool possible(const Model& model, const Level& level);

struct Walk {
  Posture before;
  Step step;
};

// Foot `holds` stands at `held`, the other goes from where `from` puts it to where `to` puts it. The motion lifts it by 21 mm,
// carries it over in `pieces` straight pieces, and sets it down.
Walk walk(const Model& model, Foot holds, const Isometry3d& held, const Level& from, const Level& to, int pieces);

// A right step on the floor, changed in one way or another, and what the judge says of it.
class CheckOfWalks : public testing::Test {
 protected:
  StepVerdict verdict(const Walk& walk) const {
    return check_step(model_, truss_, Obstacles(truss_), options_, walk.step, walk.before);
  }
  // "accepted", or the reason of the refusal.
  std::string reason_after(const std::function<void(Walk&)>& change) const;
  void expect_reason(const char* part, const std::function<void(Walk&)>& change) const;

  const Model model_ = shipped_model();
  truss::Truss truss_ = floor_scene();
  CheckOptions options_;
  const Level from_{{0.05, -0.03}, {0.28, 0.28}, {0.2, -0.3}}, to_{{0.08, -0.06}, {0.29, 0.29}, {-0.5, 0.4}};
  Walk right_ = walk(model_, Foot::kA, Isometry3d(Eigen::Translation3d(0.2, 0.1, 0.0)), from_, to_, 10);
};

// Random levels that can be lifted, and a random foothold on the floor.
class Levels {
 public:
  Levels(const Model& model, unsigned seed) : model_(model), random_(seed) {}
  Level level();
  Isometry3d foothold();
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  int integer(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }

 private:
  const Model& model_;
  std::mt19937_64 random_;
};

}  // namespace foothold::hyrecro

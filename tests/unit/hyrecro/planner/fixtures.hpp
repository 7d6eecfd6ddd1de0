// What the tests of HyReCRo's planner share: the robot of the repository, scenes, requests, and a host that judges every step.
#pragma once

#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "foothold/robot_file.hpp"
#include "hyrecro/planner.hpp"
#include "hyrecro/schema.hpp"
#include "plans/plans.hpp"

namespace foothold::hyrecro {

inline RobotModel robot() { return load_robot_model(FOOTHOLD_CONFIG_DIR "/robots/hyrecro.yaml"); }

using test::Collector;
using test::judged_plan;
using test::shipped;

// The defaults of the schema with some values set as text.
inline Parameters parameters(const std::map<std::string, std::string>& set = {}) { return test::parameters_of(kParameters, set); }

// A scene file that goes with the test.
class SceneFile {
 public:
  explicit SceneFile(const std::string& text)
      : path_(std::filesystem::path(testing::TempDir()) /
              (std::string("hyrecro_") + testing::UnitTest::GetInstance()->current_test_info()->name() + ".yaml")) {
    std::ofstream(path_) << text;
  }
  ~SceneFile() { std::filesystem::remove(path_); }
  SceneFile(const SceneFile&) = delete;
  SceneFile& operator=(const SceneFile&) = delete;
  Scene scene() const { return {"test", "", "yaml", path_.string()}; }

 private:
  std::filesystem::path path_;
};

// A sole at `at` whose +Z is `up` and whose +X is `forward`; both axes of the world, perpendicular.
inline Isometry3d sole_at(const Vector3d& at, const Vector3d& up, const Vector3d& forward) {
  Isometry3d out = Isometry3d::Identity();
  out.linear() << forward, up.cross(forward), up;
  out.translation() = at;
  return out;
}

inline Contact contact(const char* limb, const Isometry3d& pose) { return {limb, pose, ""}; }

inline Request request_between(const Isometry3d& start, const Isometry3d& goal) {
  Request request;
  request.start.contacts = {contact("A", start)};
  request.goal.contacts = {contact("", goal)};
  request.budget = 10.0;
  return request;
}

}  // namespace foothold::hyrecro

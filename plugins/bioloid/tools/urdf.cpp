// foothold-bioloid-urdf ROBOT.yaml > ROBOT.urdf: the robot's model for whoever reads URDF.
#include <cstdio>
#include <exception>

#include "bioloid/model/urdf.hpp"
#include "foothold/robot_file.hpp"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: foothold-bioloid-urdf ROBOT.yaml > ROBOT.urdf\n", stderr);
    return 2;
  }
  try {
    const auto model = foothold::bioloid::Model::from_model(foothold::load_robot_model(argv[1]));
    return std::fputs(foothold::bioloid::write_urdf(model, "bioloid").c_str(), stdout) < 0 ? 1 : 0;
  } catch (const std::exception& fault) {
    std::fprintf(stderr, "%s: %s\n", argv[1], fault.what());
    return 1;
  }
}

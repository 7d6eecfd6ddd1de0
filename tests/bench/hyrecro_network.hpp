// HyReCRo's reachability networks beside exact reachability and the paper's random search.
#pragma once

#include <vector>

#include "figures.hpp"

namespace foothold::bench {

// `network_call`: one perceptron from its inputs to its verdict; `network_reach`: from the pose, through the interface that
// searches use. Accuracy on fresh poses, and the random search on some of the same. Some ten seconds; `quick`: some seconds, on
// fewer poses. Reads the robot's file from FOOTHOLD_CONFIG_DIR.
std::vector<Figure> hyrecro_network_figures(bool quick);

}  // namespace foothold::bench

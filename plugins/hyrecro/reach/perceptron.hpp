// The perceptron of the paper (section 3.1, Figure 5): six inputs, 32 and 64 hidden units with ReLU, one output with a sigmoid.
//
// The same input gives the same logit, bit for bit, on every CPU: sums have one fixed order, and every product is added
// by a fused multiply-add, in the vectorised form as in the plain one. Hidden units that ReLU has silenced are left out of the
// sums, which changes no bit either. Values; any thread.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

namespace foothold::hyrecro {

// Metres and radians, as the perceptron takes them; what they mean is said in poses.hpp.
using NetworkInputs = std::array<float, 6>;

struct Perceptron {
  static constexpr std::size_t kInputs = 6, kFirst = 32, kSecond = 64, kLanes = 8;
  // Where each part begins in `values`. Weights of layers 1 and 2 are kept input by input: all units' weights of one input side by
  // side.
  static constexpr std::size_t kWeights1 = 0, kBias1 = kWeights1 + kInputs * kFirst, kWeights2 = kBias1 + kFirst,
                               kBias2 = kWeights2 + kFirst * kSecond, kWeights3 = kBias2 + kSecond, kBias3 = kWeights3 + kSecond;
  static constexpr std::size_t kCount = kBias3 + 1;        // parameters
  static constexpr std::size_t kStored = kBias3 + kLanes;  // padded with zeros to whole vectors

  alignas(64) std::array<float, kStored> values{};
};

// Before the sigmoid: above 0 means "reachable", more likely than not. About 30 ns.
float logit(const Perceptron& net, const NetworkInputs& inputs);
// The same without vector instructions, which is what CPUs without AVX2 and FMA run.
float logit_plain(const Perceptron& net, const NetworkInputs& inputs);

// A perceptron as text, with what is known about it: the contents of a weights file.
struct TrainedPerceptron {
  std::string comment;          // lines without their "# "
  std::string kind;             // "face" or "transition"
  std::string robot;            // the numbers of the robot for which the labels hold, see robot_numbers()
  double clearance = 0.0;       // m, for which the labels hold
  double radius = 0.0;          // m, of the sphere of poses that it was trained in
  std::size_t fresh = 0;        // poses that it was measured on
  unsigned long long seed = 0;  // of those poses
  std::size_t false_positives = 0, false_negatives = 0, reachable = 0;  // of the fresh ones
  Perceptron net;
};
// Exact: reading what was written gives the same numbers.
std::string to_text(const TrainedPerceptron& trained);
// Throws std::runtime_error that says which word is wrong or missing.
TrainedPerceptron from_text(std::string_view text);

}  // namespace foothold::hyrecro

// Reachability by two perceptrons (paper, section 3.1): one for poses within a face, one for transitions.
#include "hyrecro/reach/network.hpp"

#include <stdexcept>

#include "hyrecro/reach/reachability.hpp"
#include "hyrecro/reach/weights/weights.hpp"

namespace foothold::hyrecro {
namespace {

class Network final : public Reachability {
 public:
  explicit Network(const Model& model) {
    for (const PoseKind kind : {PoseKind::kFace, PoseKind::kTransition}) {
      const TrainedPerceptron& trained = shipped_perceptron(kind);
      if (const std::string numbers = robot_numbers(model); trained.robot != numbers)
        throw std::runtime_error("the reachability network for " + trained.kind +
                                 " poses was trained for a robot with the numbers " + trained.robot + ", not " + numbers +
                                 ": train it anew with foothold-hyrecro-train");
      net(kind) = trained.net;
      radius_squared(kind) = trained.radius * trained.radius;
    }
  }

  // Outside the ball that it was trained in nothing is reachable, so the network is not asked there.
  Reach reach(const Isometry3d& pose, const Admit&) override {
    const std::optional<PoseKind> kind = kind_of(pose);
    if (!kind || pose.translation().squaredNorm() > radius_squared(*kind)) return {};
    return {logit(net(*kind), inputs_of(*kind, pose)) > 0.0F, std::nullopt};
  }

 private:
  Perceptron& net(PoseKind kind) { return nets_[static_cast<std::size_t>(kind)]; }
  double& radius_squared(PoseKind kind) { return radius_squared_[static_cast<std::size_t>(kind)]; }

  std::array<Perceptron, 2> nets_;
  std::array<double, 2> radius_squared_{};
};

TrainedPerceptron checked(PoseKind kind, std::string_view weights) {
  TrainedPerceptron out = from_text(weights);
  if (out.kind != name_of(kind))
    throw std::runtime_error("weights for " + out.kind + " poses where those for " + name_of(kind) + " poses belong");
  return out;
}

}  // namespace

const TrainedPerceptron& shipped_perceptron(PoseKind kind) {
  static const TrainedPerceptron kFace = checked(PoseKind::kFace, kFaceWeights);
  static const TrainedPerceptron kTransition = checked(PoseKind::kTransition, kTransitionWeights);
  return kind == PoseKind::kFace ? kFace : kTransition;
}

std::unique_ptr<Reachability> make_network(const Model& model) { return std::make_unique<Network>(model); }

}  // namespace foothold::hyrecro

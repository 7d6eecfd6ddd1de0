// `iterative`: the paper's reachability. Random values of the free variables until one gives a solution, or the tries are used up.
#include <numbers>

#include "hyrecro/reach/inverse.hpp"
#include "hyrecro/reach/reachability.hpp"

namespace foothold::hyrecro {
namespace {

class Iterative final : public Reachability {
 public:
  Iterative(const Model& model, double clearance, int tries, std::mt19937_64& random)
      : model_(model), clearance_(clearance), tries_(tries), random_(random) {}

  Reach reach(const Isometry3d& pose, const Admit& admit) override {
    const bool is_singular = singular(pose);
    for (int i = 0; i < tries_; ++i) {
      const auto [branch, free] = draw(is_singular);
      const std::optional<Coordinates> found = inverse(model_, pose, branch, free);
      if (found && free_of_itself(bodies_at(model_, *found, Isometry3d::Identity()), clearance_) && (!admit || admit(*found)))
        return {true, found};
    }
    return {};
  }

 private:
  double uniform(double low, double high) { return std::uniform_real_distribution<>(low, high)(random_); }

  std::pair<Branch, Free> draw(bool is_singular) {
    const double most = model_.mechanism.greatest_phi();
    const kinematics::Interval y = model_.mechanism.offsets(0.0);
    Free free;
    free.phi1 = uniform(-most, most);
    free.lambda = uniform(2.0 * y.low - model_.core, 2.0 * y.high - model_.core);
    free.split0 = uniform(0.0, 1.0);
    free.split1 = uniform(0.0, 1.0);
    if (is_singular) free.psi1 = uniform(-2.0 * most, 2.0 * most);
    const std::uint64_t signs = random_();
    return {{is_singular || (signs & 1) != 0 ? 1 : -1, (signs & 2) != 0 ? 1 : -1}, free};
  }

  const Model model_;
  const double clearance_;
  const int tries_;
  std::mt19937_64& random_;
};

}  // namespace

std::unique_ptr<Reachability> make_iterative(const Model& model, double clearance, int tries, std::mt19937_64& random) {
  return std::make_unique<Iterative>(model, clearance, tries, random);
}

}  // namespace foothold::hyrecro

// Can the free foot be where it shall be? Three answers behind one interface.
//
// A pose is that of the free sole seen from the sole that holds (frames of the interface, +Z out of the surface). "Reachable":
// there are coordinates within the limits whose bodies keep `clearance` from each other. Scenes come in by the second argument.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <random>

#include "hyrecro/model/bodies.hpp"

namespace foothold::hyrecro {

// What else a joint solution must fulfil, such as to be free of the scene. Empty: nothing.
using Admit = std::function<bool(const Coordinates&)>;

struct Reach {
  bool reachable = false;
  std::optional<Coordinates> coordinates;  // always there from `exact` and `iterative` if reachable; never from `network`
};

// Used by one thread at a time.
class Reachability {
 public:
  virtual ~Reachability() = default;
  virtual Reach reach(const Isometry3d& free_in_holding, const Admit& admit) = 0;
};

// `iterative`: the paper's. Random values for the free variables, at most `tries` times (paper: 300).
std::unique_ptr<Reachability> make_iterative(const Model& model, double clearance, int tries, std::mt19937_64& random);
// `exact`: deterministic, from the closed form. Its positives carry a solution; see exact.hpp.
std::unique_ptr<Reachability> make_exact(const Model& model, double clearance);
// `network`: two perceptrons, one for poses within a face and one for transitions. Ignores `admit`. Throws std::runtime_error
// without weights.
std::unique_ptr<Reachability> make_network(const Model& model);

}  // namespace foothold::hyrecro

// Stops between postures that are too far apart for one transition.
#include "contact/equilibrium.hpp"
#include "octopod/posture/start.hpp"
#include "octopod/transition/body_path.hpp"
#include "octopod/transition/transition.hpp"

namespace foothold::octopod {
namespace {

constexpr int kHalvings = 3;
constexpr double kParts[] = {0.5};  // of the bodies' way, where a stop is looked for

struct Walk {
  const Model& model;
  const terrain::Surface& surface;
  const TransitionOptions& options;

  std::optional<Standing> stop(const BodyPath& path, double part) const {
    const Built built = stand_with(model, surface, path.at(part), options.clearance);
    if (built.hindrance != Hindrance::kNone) return std::nullopt;
    std::array<contact::Contact, kLegs> feet;
    for (std::size_t i = 0; i < kLegs; ++i) feet[i] = {built.standing.feet[i].point, built.standing.feet[i].normal};
    contact::Equilibrium equilibrium{contact::FrictionCone{options.cone_edges}};
    if (!equilibrium.judge(feet, built.standing.centre_of_mass, options.friction).stable) return std::nullopt;
    return built.standing;
  }

  // Appends the standings where its parts end, `to` last.
  bool connect(const Standing& from, const Standing& to, int halvings, std::vector<Standing>& stops) const {
    if (has_transition(model, surface, options, from, to)) {
      stops.push_back(to);
      return true;
    }
    if (halvings == 0) return false;
    const BodyPath path(pair_of(model, from.at), pair_of(model, to.at));
    const std::size_t before = stops.size();
    for (const double part : kParts) {
      const std::optional<Standing> between = stop(path, part);
      if (!between) continue;
      if (connect(from, *between, halvings - 1, stops) && connect(*between, to, halvings - 1, stops)) return true;
      stops.resize(before);
    }
    return false;
  }
};

}  // namespace

bool has_transitions(const Model& model, const terrain::Surface& surface, const TransitionOptions& options, const Standing& from,
                     const Standing& to) {
  std::vector<Standing> stops;
  return Walk{model, surface, options}.connect(from, to, kHalvings, stops);
}

std::vector<Transition> transitions(const Model& model, const terrain::Surface& surface, const TransitionOptions& options,
                                    const Standing& from, const Standing& to, TransitionFailure* failure) {
  std::vector<Standing> stops;
  std::vector<Transition> out;
  const Standing* last = &from;
  if (Walk{model, surface, options}.connect(from, to, kHalvings, stops))
    for (const Standing& stop : stops) {
      auto part = transition(model, surface, options, *last, stop);
      if (!part) return {};
      out.push_back(std::move(*part));
      last = &stop;
    }
  else if (failure != nullptr)
    transition(model, surface, options, from, to, failure);
  return out;
}

}  // namespace foothold::octopod

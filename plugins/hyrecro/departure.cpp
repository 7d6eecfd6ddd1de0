#include "hyrecro/departure.hpp"

#include "hyrecro/motion/lift.hpp"
#include "hyrecro/motion/rise.hpp"
#include "hyrecro/posture.hpp"

namespace foothold::hyrecro {
namespace {

// Postures that are asked whether the whole robot lifts a foot; each may take some milliseconds.
constexpr int kMostAsked = 8;

bool leaves(const Model& model, const PreparedTruss& scene, const Isometry3d& sole, const Coordinates& coordinates,
            const MotionOptions& options, const std::stop_token& stop, std::string& reason) {
  const Surroundings around{model, scene.obstacles, sole, options.clearance, stop};
  return rise(around, coordinates, options, true, reason).has_value();
}

}  // namespace

std::vector<Beginning> departures(const Model& model, const PreparedTruss& scene, const std::vector<Beginning>& from,
                                  const MotionOptions& options, const std::stop_token& stop, std::string& reason) {
  std::vector<Beginning> out;
  for (const Beginning& beginning : from)
    if (!beginning.stands ||
        leaves(model, scene, pose_of(scene.truss, beginning.holding.at), beginning.coordinates, options, stop, reason))
      out.push_back(beginning);
  return out;
}

std::optional<Coordinates> standing_on_both(const Model& model, const PreparedTruss& scene, Reachability& exact,
                                            const Isometry3d& sole, const Isometry3d& free_in_holding, const MotionOptions& options,
                                            double lift) {
  const auto free = [&](const Coordinates& c) { return is_free(model, scene, c, sole); };
  const auto find = [&](const Admit& admit) { return exact.reach(free_in_holding, admit).coordinates; };
  if (lift == 0.0) return find(free);
  if (const auto both = find([&](const Coordinates& c) { return legs_lift(model, c, lift) && free(c); })) return both;
  const auto one =
      find([&](const Coordinates& c) { return (lifted(model, c, lift) || lifted(model, swapped(c), lift)) && free(c); });
  if (one) return one;
  int asked = 0;
  const auto whole = find([&](const Coordinates& c) {
    if (asked == kMostAsked || !free(c)) return false;
    ++asked;
    std::string unused;
    return leaves(model, scene, sole, c, options, {}, unused) ||
           leaves(model, scene, sole * free_in_holding, swapped(c), options, {}, unused);
  });
  return whole ? whole : find(free);
}

}  // namespace foothold::hyrecro

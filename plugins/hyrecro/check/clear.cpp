#include "hyrecro/check/clear.hpp"

#include "hyrecro/check/refusal.hpp"

namespace foothold::hyrecro {
namespace {

using collision::Box;
using collision::Capsule;

// "leg 0" of the model's order by the feet's names.
std::string named(const std::string& body, Foot holds) {
  if (body.empty() || (body.back() != '0' && body.back() != '1')) return body;
  return body.substr(0, body.size() - 1) + name_of(body.back() == '0' ? holds : other(holds));
}

std::string solid_name(const Setting& setting, int solid) {
  const std::string& name = setting.truss.solids[static_cast<std::size_t>(solid)].name;
  return name.empty() ? "solid " + std::to_string(solid) : "'" + name + "'";
}

template <class Use>
auto with_pair(const Bodies& b, std::size_t pair, const Use& use) {
  switch (pair) {
    case 0:
      return use(b.leg[0], b.leg[1]);
    case 1:
      return use(b.leg[0], b.plate[1]);
    case 2:
      return use(b.leg[1], b.plate[0]);
    case 3:
      return use(b.plate[0], b.hip);
    case 4:
      return use(b.plate[1], b.hip);
    default:
      return use(b.plate[0], b.plate[1]);
  }
}

constexpr std::array<std::pair<const char*, const char*>, kPairs> kPairNames{{{"leg 0", "leg 1"},
                                                                              {"leg 0", "plate 1"},
                                                                              {"leg 1", "plate 0"},
                                                                              {"plate 0", "hip"},
                                                                              {"plate 1", "hip"},
                                                                              {"plate 0", "plate 1"}}};

}  // namespace

Bodies thinner(const Bodies& bodies, double by) {
  Bodies out = bodies;
  const auto thin = [by](const Vector3d& half) { return Vector3d((half.array() - by).cwiseMax(0.0)); };
  for (Capsule& leg : out.leg) leg.radius = std::max(0.0, leg.radius - by);
  for (Box& plate : out.plate) plate.half = thin(plate.half);
  out.hip.half = thin(out.hip.half);
  return out;
}

double pair_distance(const Bodies& bodies, std::size_t pair) {
  return with_pair(bodies, pair, [](const auto& a, const auto& b) { return collision::distance(a, b); });
}

bool pair_nearer(const Bodies& bodies, std::size_t pair, double clearance) {
  return with_pair(bodies, pair, [&](const auto& a, const auto& b) { return collision::nearer(a, b, clearance); });
}

std::string pair_name(std::size_t pair, Foot holds) {
  return named(kPairNames[pair].first, holds) + " and " + named(kPairNames[pair].second, holds);
}

void judge_clear(const Setting& setting, const Coordinates& coordinates, const std::string& where, Clearance& least) {
  const Bodies bodies = thinner(bodies_at(setting.model, coordinates, setting.held), kTouch);
  const double clearance = setting.options.clearance;
  const Obstacles::Nearest near = setting.obstacles.nearest(bodies, std::max(clearance, least.scene));
  if (near.distance <= clearance)
    refuse(where, ": ", named(near.body, setting.holds), " comes within ", near.distance, " m of ", solid_name(setting, near.solid),
           ", ", clearance, " m must be kept");
  least.scene = std::min(least.scene, near.distance);
  const Obstacles::Nearest plates = setting.obstacles.nearest_of_plates(bodies, 0.0);
  if (plates.distance <= 0.0) refuse(where, ": ", named(plates.body, setting.holds), " is in ", solid_name(setting, plates.solid));
  for (std::size_t pair = 0; pair < kPairs; ++pair) {
    const double distance = pair_distance(bodies, pair);
    if (distance <= clearance)
      refuse(where, ": ", pair_name(pair, setting.holds), " come within ", distance, " m of each other, ", clearance,
             " m must be kept");
    least.itself = std::min(least.itself, distance);
  }
}

}  // namespace foothold::hyrecro

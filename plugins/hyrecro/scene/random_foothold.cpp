// Rejection sampling.
#include "hyrecro/scene/random_foothold.hpp"

#include <algorithm>
#include <cmath>

#include "hyrecro/scene/transitions.hpp"

namespace foothold::hyrecro {
namespace {

// Own draws: the standard's distributions differ between libraries.
double uniform(std::mt19937_64& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random() >> 11) * 0x1.0p-53;
}

double to_millionths(double value) { return std::round(value * 1e6) * 1e-6; }

}  // namespace

std::optional<Foothold> random_foothold(const Model& model, const truss::Truss& truss, std::mt19937_64& random) {
  constexpr int kTries = 10000;
  std::vector<double> areas;
  double sum = 0.0;
  for (const truss::Face& face : truss.faces) areas.push_back(sum += geometry::area(Region{face.outline, face.holes}));
  for (int k = 0; k < kTries && sum > 0.0; ++k) {
    const auto at = std::upper_bound(areas.begin(), areas.end(), uniform(random, 0.0, sum));
    const auto index = std::min(static_cast<std::size_t>(at - areas.begin()), areas.size() - 1);
    const truss::Face& face = truss.faces[index];
    Eigen::AlignedBox2d box;
    for (const Vector2d& v : face.outline) box.extend(v);
    const double x = to_millionths(uniform(random, box.min().x(), box.max().x()));
    const double y = to_millionths(uniform(random, box.min().y(), box.max().y()));
    const Foothold foothold{static_cast<int>(index), {x, y}, to_millionths(uniform(random, -3.141592, 3.141592))};
    if (plate_on_face(model, face, foothold)) return foothold;
  }
  return std::nullopt;
}

}  // namespace foothold::hyrecro

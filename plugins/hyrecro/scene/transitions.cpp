// Sampling of all pairs of faces that are near each other.
#include "hyrecro/scene/transitions.hpp"

#include <algorithm>
#include <cmath>
#include <nanoflann.hpp>
#include <numbers>

#include "geometry/near_boxes.hpp"
#include "hyrecro/scene/face_pair.hpp"

namespace foothold::hyrecro {
namespace {

// Every `step` along the stretch, centred, and both ends.
void add_samples(const Stretch& stretch, double step, std::vector<double>& out) {
  constexpr double kSame = 1e-6;  // m
  const double length = stretch.end - stretch.begin;
  const double count = std::floor(length / step + 1e-6);
  const double rest = 0.5 * (length - count * step);
  if (rest > kSame) out.push_back(stretch.begin);
  for (int k = 0; k <= static_cast<int>(count); ++k)
    out.push_back(std::clamp(stretch.begin + rest + k * step, stretch.begin, stretch.end));
  if (rest > kSame) out.push_back(stretch.end);
}

class Sampler {
 public:
  Sampler(const Model& model, const truss::Truss& truss, const SamplingOptions& options, std::vector<TransitionFoothold>& all)
      : model_(model), truss_(truss), options_(options), all_(all) {
    convex_ = options.also_convex;
    convex_.insert(convex_.begin(), options.convex);
    concave_ = options.also_concave;
    concave_.insert(concave_.begin(), options.concave);
    for (const truss::Face& face : truss.faces) faces_.push_back(seen(face));
  }

  void sample() {
    std::vector<Eigen::AlignedBox3d> bounds;
    bounds.reserve(faces_.size());
    for (const SeenFace& face : faces_) bounds.push_back(face.bounds);
    // Two soles stand at most this far apart: on faces that look at each other almost, both at their distance from the line.
    const double far = *std::max_element(concave_.begin(), concave_.end());
    const double near = *std::max_element(convex_.begin(), convex_.end());
    const double margin = std::hypot(2.0 * std::max(far, near), model_.hip_distance);
    geometry::for_near_pairs(bounds, margin, [&](int i, int j) { sample(i, j); });
  }

 private:
  void sample(int i, int j) {
    const SeenFace &a = faces_[static_cast<std::size_t>(i)], &b = faces_[static_cast<std::size_t>(j)];
    const std::optional<FacePair> pair = meet(a, b);
    if (!pair) return;
    if (const std::vector<Stretch> edge = convex_edge(*pair); !edge.empty()) sample(*pair, {i, j}, convex_, &edge);
    if (a.face->solid == b.face->solid && a.face->solid >= 0) return;  // a box bends outwards everywhere
    const double half = 0.5 * model_.plate.x();
    for (std::size_t k = 0; k < 2; ++k)
      if (std::none_of(concave_.begin(), concave_.end(), [&](double d) { return concave_room(*pair, k, d, half); })) return;
    sample(*pair, {i, j}, concave_, nullptr);
  }

  // Both faces of a pair, at all distances. `edge`: the convex edge that they share, or none.
  void sample(const FacePair& pair, const std::array<int, 2>& index, const std::vector<double>& distances,
              const std::vector<Stretch>* edge) {
    std::array<std::vector<SoleLine>, 2> lines;
    std::array<std::vector<Stretch>, 2> stretches;
    for (std::size_t k = 0; k < 2; ++k) {
      for (const double distance : distances) {
        lines[k].push_back(sole_line(model_, pair, k, distance, edge == nullptr));
        std::vector<Stretch>& own = lines[k].back().stretches;
        if (edge != nullptr) own = near_to(own, *edge, 0.0);
        stretches[k].insert(stretches[k].end(), own.begin(), own.end());
      }
      if (stretches[k].empty()) return;
      std::sort(stretches[k].begin(), stretches[k].end(), [](const Stretch& a, const Stretch& b) { return a.begin < b.begin; });
    }
    for (std::size_t k = 0; k < 2; ++k)
      for (const SoleLine& line : lines[k]) {
        places_.clear();
        for (const Stretch& part : near_to(line.stretches, stretches[1 - k], model_.hip_distance))
          add_samples(part, options_.step, places_);
        for (const double t : places_) add(index[k], index[1 - k], line, t, edge != nullptr);
      }
  }

  void add(int face, int towards, const SoleLine& line, double t, bool convex) {
    for (int turned = 0; turned <= (options_.both_headings ? 1 : 0); ++turned) {
      double heading = line.heading;
      if (turned == 1) heading += heading > 0.0 ? -std::numbers::pi : std::numbers::pi;
      const Foothold foothold{face, line.origin + t * line.along, heading};
      all_.push_back({foothold, pose_of(truss_, foothold), towards, convex});
    }
  }

  const Model& model_;
  const truss::Truss& truss_;
  const SamplingOptions& options_;
  std::vector<TransitionFoothold>& all_;
  std::vector<double> convex_, concave_;
  std::vector<SeenFace> faces_;
  std::vector<double> places_;
};

}  // namespace

struct Transitions::Tree {
  std::vector<Vector3d> points;

  std::size_t kdtree_get_point_count() const { return points.size(); }
  double kdtree_get_pt(std::size_t index, std::size_t axis) const { return points[index][static_cast<Eigen::Index>(axis)]; }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }

  using Index = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Tree>, Tree, 3, std::uint32_t>;
  std::unique_ptr<Index> search;
};

Transitions::Transitions(const Model& model, const truss::Truss& truss, const SamplingOptions& options)
    : by_face_(truss.faces.size()) {
  Sampler(model, truss, options, all_).sample();
  auto tree = std::make_unique<Tree>();
  tree->points.reserve(all_.size());
  for (std::size_t k = 0; k < all_.size(); ++k) {
    by_face_[static_cast<std::size_t>(all_[k].foothold.face)].push_back(static_cast<int>(k));
    tree->points.push_back(all_[k].pose.translation());
  }
  tree->search = std::make_unique<Tree::Index>(3, *tree, nanoflann::KDTreeSingleIndexAdaptorParams(16));
  tree_ = std::move(tree);
}

Transitions::~Transitions() = default;
Transitions::Transitions(Transitions&&) noexcept = default;

std::vector<int> Transitions::near(const Vector3d& point, double radius, int face) const {
  std::vector<std::pair<std::uint32_t, double>> matches;
  tree_->search->radiusSearch(point.data(), radius * radius, matches, nanoflann::SearchParams());
  std::vector<int> out;
  out.reserve(matches.size());
  for (const auto& [index, squared] : matches)
    if (all_[index].foothold.face != face) out.push_back(static_cast<int>(index));
  return out;
}

}  // namespace foothold::hyrecro

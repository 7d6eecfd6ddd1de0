// Sampling of all pairs of faces that are near each other.
#include "hyrecro/scene/transitions.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>
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

// Soles along one line of one face, before they become footholds.
struct Row {
  int face, towards;
  bool convex;
  Vector2d origin, along;
  double heading;
  std::size_t begin, end;  // of the places t
};

class Sampler {
 public:
  Sampler(const Model& model, const truss::Truss& truss, const SamplingOptions& options)
      : model_(model), options_(options), convex_(options.also_convex), concave_(options.also_concave) {
    convex_.insert(convex_.begin(), options.convex);
    concave_.insert(concave_.begin(), options.concave);
    faces_.reserve(truss.faces.size());
    for (const truss::Face& face : truss.faces) faces_.emplace_back(face);
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

  const std::vector<Row>& rows() const { return rows_; }
  const std::vector<double>& places() const { return places_; }

 private:
  void sample(int i, int j) {
    const SeenFace &a = faces_[static_cast<std::size_t>(i)], &b = faces_[static_cast<std::size_t>(j)];
    const std::optional<FacePair> pair = meet(a, b, model_.hip_distance);
    if (!pair) return;
    if (const std::vector<Stretch> edge = convex_edge(*pair); !edge.empty()) sample(*pair, {i, j}, convex_, &edge);
    if (a.face->solid == b.face->solid && a.face->solid >= 0) return;  // a box bends outwards everywhere
    const double half = 0.5 * model_.plate.x();
    for (const auto& off : pair->off)
      if (std::none_of(concave_.begin(), concave_.end(),
                       [&](double d) { return off[0] <= d - half + 1e-6 && off[1] >= d + half - 1e-6; }))
        return;
    sample(*pair, {i, j}, concave_, nullptr);
  }

  // Both faces of a pair, at all distances. `edge`: the convex edge that they share, or none.
  void sample(const FacePair& pair, const std::array<int, 2>& index, const std::vector<double>& distances,
              const std::vector<Stretch>* edge) {
    const double apart = model_.hip_distance;
    std::array<std::vector<SoleLine>, 2> lines;
    std::array<std::vector<Stretch>, 2> stretches;
    for (std::size_t k = 0; k < 2; ++k) {
      const Stretch& other = pair.along[1 - k];
      const Stretch window = edge != nullptr ? Stretch{edge->front().begin, edge->back().end}
                                             : Stretch{std::max(pair.along[k].begin, other.begin - apart),
                                                       std::min(pair.along[k].end, other.end + apart)};
      for (const double distance : distances) {
        lines[k].push_back(sole_line(model_, pair, k, distance, edge == nullptr, window));
        std::vector<Stretch>& own = lines[k].back().stretches;
        if (edge != nullptr) own = near_to(own, *edge, 0.0);
        stretches[k].insert(stretches[k].end(), own.begin(), own.end());
      }
      if (stretches[k].empty()) return;
      std::sort(stretches[k].begin(), stretches[k].end(), [](const Stretch& a, const Stretch& b) { return a.begin < b.begin; });
    }
    for (std::size_t k = 0; k < 2; ++k)
      for (const SoleLine& line : lines[k]) {
        const std::size_t begin = places_.size();
        for (const Stretch& part : near_to(line.stretches, stretches[1 - k], apart)) add_samples(part, options_.step, places_);
        if (places_.size() > begin)
          rows_.push_back({index[k], index[1 - k], edge != nullptr, line.origin, line.along, line.heading, begin, places_.size()});
      }
  }

  const Model& model_;
  const SamplingOptions& options_;
  std::vector<double> convex_, concave_;
  std::vector<SeenFace> faces_;
  std::vector<Row> rows_;
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
  std::once_flag made;
};

Transitions::Transitions(const Model& model, const truss::Truss& truss, const SamplingOptions& options)
    : by_face_(truss.faces.size()), tree_(std::make_unique<Tree>()) {
  Sampler sampler(model, truss, options);
  sampler.sample();
  const int headings = options.both_headings ? 2 : 1;
  std::vector<std::size_t> counts(truss.faces.size(), 0);
  for (const Row& row : sampler.rows())
    counts[static_cast<std::size_t>(row.face)] += (row.end - row.begin) * static_cast<std::size_t>(headings);
  for (std::size_t f = 0; f < counts.size(); ++f) by_face_[f].reserve(counts[f]);
  all_.reserve(sampler.places().size() * static_cast<std::size_t>(headings));
  for (const Row& row : sampler.rows()) {
    const Isometry3d& frame = truss.faces[static_cast<std::size_t>(row.face)].frame;
    for (int turned = 0; turned < headings; ++turned) {
      double heading = row.heading;
      if (turned == 1) heading += heading > 0.0 ? -std::numbers::pi : std::numbers::pi;
      TransitionFoothold sole{{row.face, row.origin, heading}, {}, row.towards, row.convex};
      sole.pose = pose_of(truss, sole.foothold);
      for (std::size_t k = row.begin; k < row.end; ++k) {
        sole.foothold.at = row.origin + sampler.places()[k] * row.along;
        sole.pose.translation() = frame * Vector3d(sole.foothold.at.x(), sole.foothold.at.y(), 0.0);
        by_face_[static_cast<std::size_t>(row.face)].push_back(static_cast<int>(all_.size()));
        all_.push_back(sole);
      }
    }
  }
}

Transitions::~Transitions() = default;
Transitions::Transitions(Transitions&&) noexcept = default;

std::vector<int> Transitions::near(const Vector3d& point, double radius, int face) const {
  std::call_once(tree_->made, [this] {
    tree_->points.reserve(all_.size());
    for (const TransitionFoothold& sole : all_) tree_->points.push_back(sole.pose.translation());
    tree_->search = std::make_unique<Tree::Index>(3, *tree_, nanoflann::KDTreeSingleIndexAdaptorParams(16));
  });
  std::vector<std::pair<std::uint32_t, double>> matches;
  tree_->search->radiusSearch(point.data(), radius * radius, matches, nanoflann::SearchParams());
  std::vector<int> out;
  out.reserve(matches.size());
  for (const auto& [index, squared] : matches)
    if (all_[index].foothold.face != face) out.push_back(static_cast<int>(index));
  return out;
}

}  // namespace foothold::hyrecro

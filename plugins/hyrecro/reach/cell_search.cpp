#include "hyrecro/reach/cell_search.hpp"

#include <algorithm>
#include <cmath>

#include "collision/distance.hpp"
#include "hyrecro/reach/inverse.hpp"

namespace foothold::hyrecro {
namespace {

// A posture must be this far inside the limits (m) to be offered.
constexpr double kInside = 1e-8;
// The slopes' bounds add up what cannot all happen at once; measured against random search, half of it loses nothing.
constexpr double kTrust = 0.5;
constexpr std::size_t kSingularLevels = 4, kRegularLevels = 5, kClimbLevels = 5;
// Where no cell's centre is within limits, the search goes on with so many of the best.
constexpr std::size_t kClimbers = 96;
// The first climb: from so many cells, on the grid of this level, until there is as much room (m).
constexpr std::size_t kFirstClimbs = 6, kClimbLevel = 6;
constexpr double kRoomy = 0.01;

}  // namespace

CellSearch::CellSearch(const Model& model, double clearance, const CellSearchOptions& options)
    : model_(model), limits_(model), clearance_(clearance), options_(options) {
  const double most = model.mechanism.greatest_phi(), b = model.mechanism.base();
  const kinematics::Interval straight = model.mechanism.offsets(0.0);
  const double longest = 2.0 * straight.high - model.core, half_stroke = straight.high - straight.low;
  for (std::size_t level = 0; level < kSingularLevels + kClimbLevels; ++level) {
    const int angles = 5 << level, lengths = 3 << level;
    const double d_phi = most / angles, d_psi = 2.0 * d_phi;
    const double shift = longest * d_phi + model.hip_drop * d_psi + half_stroke / lengths + b * d_psi;
    const double turned = (model.hip_distance + model.hip_drop) * d_psi;
    singular_grids_.push_back({angles, lengths, kTrust * (LegLimits::kSlope * (shift + turned) + limits_.turn_slope() * d_psi),
                               shift, kTrust * (2.0 * shift + turned)});
    auto& ticks = singular_ticks_.emplace_back();
    for (int i = 0; i < angles; ++i) ticks.push_back(tick(most * (2.0 * i + 1.0 - angles) / angles));
  }
  for (std::size_t level = 0; level < kRegularLevels + kClimbLevels; ++level) {
    const int angles = 10 << level, lengths = 4 << level;
    const double d_phi = most / angles;
    const double shift = (longest + 2.0 * b) * d_phi + half_stroke / lengths;
    regular_grids_.push_back({angles, lengths, kTrust * LegLimits::kSlope * shift, shift, kTrust * 2.0 * shift});
  }
  for (auto* cells : {&cells_, &halved_, &inside_}) cells->reserve(options.most_cells);
}

CellSearch::Tick CellSearch::tick(double angle) const {
  const double cosine = std::cos(angle), sine = std::sin(angle);
  return {angle, cosine, sine, limits_.stroke(cosine, sine)};
}

void CellSearch::set_up(const Isometry3d& pose) {
  pose_ = PaperPose(pose);
  singular_ = std::hypot(pose_.r(0, 2), pose_.r(1, 2)) < kSingular;
  postures_ = offers_ = 0;
  cells_.clear();
  inside_.clear();
  const Vector3d raised(0.0, 0.5 * (model_.skin + model_.plate.z()), 0.0);
  for (std::size_t j = 0; j < 2; ++j) {
    collision::Box& plate = bodies_.plate[j];
    plate.half = 0.5 * Vector3d(model_.plate.x(), model_.plate.z() - model_.skin, model_.plate.y());
    plate.pose.setIdentity();
    if (j == 1) plate.pose.linear() = pose_.r;
    plate.pose.translation() = j == 1 ? Vector3d(pose_.p + pose_.r * raised) : raised;
  }
  bodies_.hip.half = 0.5 * Vector3d(model_.hip_plate.x(), model_.hip_plate.z(), model_.hip_plate.y());
  if (singular_) return;
  for (std::size_t branch = 0; branch < 2; ++branch) {
    const double s1 = branch == 0 ? 1.0 : -1.0, psi0 = std::atan2(s1 * pose_.r(1, 2), s1 * pose_.r(0, 2));
    const double c = std::cos(psi0), s = std::sin(psi0);
    const double sin1 = -(c * pose_.r(1, 0) - s * pose_.r(0, 0)), cos1 = c * pose_.r(1, 1) - s * pose_.r(0, 1);
    regular_turn_[branch] = {c, s, cos1, sin1};
  }
}

// Angles of phi1 and phi2 at the cells' centres of a level.
void CellSearch::set_ticks(std::size_t level) {
  if (singular_) {
    lengths_ = singular_grids_[level].lengths;
    first_[0] = second_[0] = singular_ticks_[level].data();
    return;
  }
  lengths_ = regular_grids_[level].lengths;
  const double most = model_.mechanism.greatest_phi();
  const int count = regular_grids_[level].angles;
  for (std::size_t branch = 0; branch < 2; ++branch) {
    auto &one = regular_first_[branch], &two = regular_second_[branch];
    one.clear();
    two.clear();
    const double psi = std::atan2(regular_turn_[branch].sin1, regular_turn_[branch].cos1);
    const double low = std::max(-most, psi - most), high = std::min(most, psi + most);
    for (int i = 0; i < count && low <= high; ++i) {
      const double phi1 = low + (high - low) * (i + 0.5) / count;
      one.push_back(tick(phi1));
      two.push_back(tick(psi - phi1));
    }
    first_[branch] = one.data();
    second_[branch] = two.data();
  }
}

CellSearch::Posture CellSearch::at(const Cell& cell) const {
  const std::size_t branch = cell.s1 > 0 ? 0 : 1;
  const Tick& one = first_[branch][cell.i];
  const Tick& two = second_[branch][singular_ ? cell.j : cell.i];
  const double half = 0.5 * (one.stroke.high + two.stroke.high - one.stroke.low - two.stroke.low);
  const double place = (2.0 * cell.k + 1.0 - lengths_) / lengths_;
  Posture out;
  out.lambda = 0.5 * (one.stroke.high + two.stroke.high + one.stroke.low + two.stroke.low) - model_.core + place * half;
  const double margin1 = limits_.margin(out.lambda, one.stroke, two.stroke);

  const Matrix3d& r = pose_.r;
  Turn& turn = out.turn;
  if (singular_) {
    turn.cos1 = one.cosine * two.cosine - one.sine * two.sine;
    turn.sin1 = one.sine * two.cosine + one.cosine * two.sine;
    turn.sin0 = r(0, 0) * turn.sin1 - r(0, 1) * turn.cos1;
    turn.cos0 = r(1, 1) * turn.cos1 - r(1, 0) * turn.sin1;
  } else {
    turn = regular_turn_[branch];
  }
  const double hx = -out.lambda * one.sine - model_.hip_drop * turn.sin1;
  const double hy = model_.ankle_height + out.lambda * one.cosine + model_.hip_drop * turn.cos1;
  const double ux = pose_.p.x() + r(0, 0) * hx + r(0, 1) * hy, uy = pose_.p.y() + r(1, 0) * hx + r(1, 1) * hy;
  out.uz = pose_.p.z() + r(2, 0) * hx + r(2, 1) * hy;
  out.beyond = std::fabs(out.uz) - model_.hip_distance;
  const double across = cell.s2 * std::sqrt(std::max(0.0, model_.hip_distance * model_.hip_distance - out.uz * out.uz));
  out.wx = ux - across * turn.cos0 + model_.hip_drop * turn.sin0;
  out.wy = uy - across * turn.sin0 - model_.hip_drop * turn.cos0 - model_.ankle_height;
  out.margin = std::min(margin1, limits_.margin(out.wx, out.wy, turn.cos0, turn.sin0));
  return out;
}

// How much further or less far across the hip may be in the cell: not of bounded slope where it is all across, so bounded by the
// interval of its sine.
double CellSearch::swing(const Posture& posture, const Grid& grid) const {
  if (singular_) return 0.0;
  const double t = model_.hip_distance, side = std::fabs(posture.uz), change = side_change(grid);
  const auto across = [t](double z) { return std::sqrt(std::max(0.0, t * t - z * z)); };
  const double here = across(side);
  return std::max(across(std::max(0.0, side - change)) - here, here - across(side + change));
}

// Whether anything in the cell can be within limits, and the legs apart.
bool CellSearch::may_hold(const Cell& cell, const Posture& posture, const Grid& grid, bool judge_legs) const {
  if (posture.beyond > side_change(grid)) return false;
  if (posture.margin + grid.radius < 0.0 && posture.margin + grid.radius + LegLimits::kSlope * swing(posture, grid) < 0.0)
    return false;
  if (!judge_legs || posture.beyond > 0.0) return true;
  const auto [leg0, leg1] = legs(cell, posture);
  const double gap = clearance_ - grid.legs;
  return gap <= -leg0.radius - leg1.radius || !collision::nearer(leg0, leg1, gap - swing(posture, grid));
}

void CellSearch::add(Cell cell, const Grid& grid, bool judge_legs) {
  const Posture posture = at(cell);
  if (!may_hold(cell, posture, grid, judge_legs)) return;
  cell.margin = posture.beyond > 0.0 ? std::min(posture.margin, -posture.beyond) : posture.margin;
  cells_.push_back(cell);
  if (cell.margin > kInside) inside_.push_back(cell);
}

void CellSearch::refine(const Grid& grid) {
  const auto roomier = [](const Cell& a, const Cell& b) { return a.margin > b.margin; };
  if (cells_.size() > options_.most_cells / 8) {
    const auto end = cells_.begin() + static_cast<std::ptrdiff_t>(options_.most_cells / 8);
    std::nth_element(cells_.begin(), end, cells_.end(), roomier);
    cells_.erase(end, cells_.end());
  }
  cells_.swap(halved_);
  cells_.clear();
  for (const Cell& cell : halved_)
    for (int part = 0; part < (singular_ ? 8 : 4); ++part) {
      Cell child = cell;
      child.i = static_cast<short>(2 * cell.i + (part & 1));
      child.k = static_cast<short>(2 * cell.k + (part >> 1 & 1));
      child.j = static_cast<short>(2 * cell.j + (part >> 2));
      add(child, grid, true);
    }
}

// In the paper's frame of the sole that holds.
std::array<collision::Capsule, 2> CellSearch::legs(const Cell& cell, const Posture& posture) const {
  const Tick& one = first_[cell.s1 > 0 ? 0 : 1][cell.i];
  const double a = model_.ankle_height, begin = model_.leg_begin;
  const Vector3d w0(posture.wx, posture.wy, 0.0), ankle0(0.0, a, 0.0);
  const Vector3d ankle1 = pose_.p + a * pose_.r.col(1), n1 = one.cosine * pose_.r.col(1) - one.sine * pose_.r.col(0);
  return {collision::Capsule{ankle0 + (begin / w0.norm()) * w0, ankle0 + w0, model_.leg_radius},
          collision::Capsule{ankle1 + begin * n1, ankle1 + posture.lambda * n1, model_.leg_radius}};
}

bool CellSearch::free_of_itself(const Cell& cell, const Posture& posture) {
  bodies_.leg = legs(cell, posture);
  if (collision::nearer(bodies_.leg[0], bodies_.leg[1], clearance_)) return false;
  const Turn& turn = posture.turn;
  const double t = model_.hip_distance, across = cell.s2 * std::sqrt(std::max(0.0, t * t - posture.uz * posture.uz));
  const Vector3d up(-turn.sin0, turn.cos0, 0.0), along(across * turn.cos0, across * turn.sin0, posture.uz);
  bodies_.hip.pose.linear() << along / t, up, (along / t).cross(up);
  bodies_.hip.pose.translation() = bodies_.leg[0].b + model_.hip_drop * up + 0.5 * along;
  return hyrecro::free_of_itself(bodies_, clearance_);
}

Coordinates CellSearch::coordinates(const Cell& cell, const Posture& posture) const {
  const std::size_t branch = cell.s1 > 0 ? 0 : 1;
  const Tick& one = first_[branch][cell.i];
  const Turn& turn = posture.turn;
  const auto leg = [&](double phi1, double psi, double lambda) {
    const double phi2 = wrapped(psi - phi1);
    const kinematics::Interval y1 = first_offsets(model_, phi1, phi2, lambda);
    const double y = 0.5 * (y1.low + y1.high);
    return Leg{phi1, y, phi2, lambda + model_.core - y};
  };
  const double sine = -posture.uz / model_.hip_distance;
  const double hip0 = std::atan2(sine, cell.s2 * std::sqrt(std::max(0.0, 1.0 - sine * sine)));
  const double hips = std::atan2(turn.cos0 * pose_.r(0, 2) + turn.sin0 * pose_.r(1, 2), pose_.r(2, 2));
  return {{leg(std::atan2(-posture.wx, posture.wy), std::atan2(turn.sin0, turn.cos0), std::hypot(posture.wx, posture.wy)),
           leg(one.angle, std::atan2(turn.sin1, turn.cos1), posture.lambda)},
          {hip0, wrapped(hip0 - hips)}};
}

bool CellSearch::take(const Cell& cell, const Posture& posture, const Offer& offer) {
  ++postures_;
  if (!free_of_itself(cell, posture)) return false;
  ++offers_;
  return offer(coordinates(cell, posture));
}

// What is inside the limits, roomiest first.
bool CellSearch::offer_all(const Offer& offer) {
  const auto less_room = [](const Cell& a, const Cell& b) { return a.margin < b.margin; };
  std::make_heap(inside_.begin(), inside_.end(), less_room);
  while (!inside_.empty() && !spent()) {
    std::pop_heap(inside_.begin(), inside_.end(), less_room);
    const Cell cell = inside_.back();
    inside_.pop_back();
    if (take(cell, at(cell), offer)) return true;
  }
  return false;
}

// Pattern search by the margin on a fine grid, from the best cells of the coarsest.
bool CellSearch::climb(const Offer& offer) {
  constexpr int directions[][3] = {{1, 0, 0},  {-1, 0, 0}, {0, 1, 0},  {0, -1, 0}, {0, 0, 1},
                                   {0, 0, -1}, {1, -1, 0}, {-1, 1, 0}, {1, 1, 0},  {-1, -1, 0}};
  const auto roomier = [](const Cell& a, const Cell& b) { return a.margin > b.margin; };
  const std::size_t climbs = std::min(kFirstClimbs, cells_.size());
  halved_.resize(climbs);
  std::partial_sort_copy(cells_.begin(), cells_.end(), halved_.begin(), halved_.end(), roomier);
  set_ticks(kClimbLevel);
  const Grid& grid = singular_grids_[kClimbLevel];
  for (Cell best : halved_) {
    const auto finer = [](short index) { return static_cast<short>((index << kClimbLevel) + (1 << (kClimbLevel - 1))); };
    best.i = finer(best.i);
    best.j = finer(best.j);
    best.k = finer(best.k);
    Posture posture = at(best);
    for (int step = 1 << (kClimbLevel - 1); step > 0 && posture.margin < kRoomy;) {
      bool better = false;
      for (const auto& d : directions) {
        const int i = best.i + step * d[0], j = best.j + step * d[1], k = best.k + step * d[2];
        if (std::min({i, j, k}) < 0 || std::max(i, j) >= grid.angles || k >= grid.lengths) continue;
        Cell next = best;
        next.i = static_cast<short>(i);
        next.j = static_cast<short>(j);
        next.k = static_cast<short>(k);
        const Posture there = at(next);
        if (there.margin <= posture.margin) continue;
        better = true;
        best = next;
        posture = there;
      }
      if (!better) step /= 2;
    }
    if (posture.margin > kInside && take(best, posture, offer)) return true;
  }
  return false;
}

bool CellSearch::search(const Isometry3d& free_in_holding, const Offer& offer) {
  set_up(free_in_holding);
  if (singular_ && std::fabs(pose_.p.z()) > model_.hip_distance) return false;
  const std::vector<Grid>& grids = singular_ ? singular_grids_ : regular_grids_;
  const std::size_t levels = singular_ ? kSingularLevels : kRegularLevels;

  set_ticks(0);
  for (const int s1 : {1, -1}) {
    if (singular_ && s1 < 0) break;
    const auto count = static_cast<short>(singular_ ? grids[0].angles : static_cast<int>(regular_first_[s1 > 0 ? 0 : 1].size()));
    for (const int s2 : {1, -1})
      for (short i = 0; i < count; ++i)
        for (short j = 0; j < (singular_ ? count : 1); ++j)
          for (short k = 0; k < lengths_; ++k)
            add({i, j, k, static_cast<signed char>(s1), static_cast<signed char>(s2), 0.0}, grids[0], false);
  }
  if (singular_ && inside_.empty() && climb(offer)) return true;
  for (std::size_t level = 1;; ++level) {
    if (offer_all(offer)) return true;
    if (level == grids.size() || cells_.empty() || spent()) return false;
    if (level >= levels) {
      if (postures_ > 0) return false;
      if (cells_.size() > kClimbers) {
        const auto end = cells_.begin() + static_cast<std::ptrdiff_t>(kClimbers);
        std::nth_element(cells_.begin(), end, cells_.end(), [](const Cell& a, const Cell& b) { return a.margin > b.margin; });
        cells_.erase(end, cells_.end());
      }
    }
    set_ticks(level);
    refine(grids[level]);
  }
}

}  // namespace foothold::hyrecro

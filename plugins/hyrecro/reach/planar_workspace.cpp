#include "hyrecro/reach/planar_workspace.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <unordered_map>

#include "hyrecro/reach/exact.hpp"

namespace foothold::hyrecro {
namespace {

// A leg turned by half a turn about its sole's normal is the same leg with its angles reversed.
Leg reversed(const Leg& leg) { return {-leg.phi1, leg.y1, -leg.phi2, leg.y2}; }

}  // namespace

// Entries are those poses with x, y >= 0 and, if a half turn is on the grid, headings below it.
struct PlanarWorkspace::Table {
  Table(const Model& model, double clearance) : postures(model, clearance) {}

  PlanarPostures postures;
  int headings = 0;                                       // of an entry's position
  std::vector<bool> reachable;                            // of all poses
  std::vector<float> shift1;                              // of the entries' level postures
  std::vector<bool> backwards;                            // their side is -1
  std::unordered_map<std::size_t, Coordinates> inclined;  // entries that have no level posture
};

std::size_t PlanarWorkspace::index(int i, int j, int k) const {
  const int width = 2 * extent_ + 1;
  return (static_cast<std::size_t>(i + extent_) * static_cast<std::size_t>(width) + static_cast<std::size_t>(j + extent_)) *
             static_cast<std::size_t>(headings_) +
         static_cast<std::size_t>(k);
}

PlanarPose PlanarWorkspace::pose(int i, int j, int k) const {
  return {i * position_step_, j * position_step_, wrapped(k * heading_step_)};
}

// Turning both feet by half a turn takes (x, y, heading) to (-x, -y, heading), the mirror in the holding foot's X axis to (x, -y,
// -heading), and turning the free foot by half a turn adds pi to the heading.
PlanarWorkspace::Canonical PlanarWorkspace::canonical(int i, int j, int k) const {
  Canonical out{0, false, false, false};
  if (i < 0) {
    out.holding_turned = out.free_turned = true;
    i = -i;
    j = -j;
  }
  if (j < 0) {
    out.mirrored = true;
    j = -j;
    k = (headings_ - k) % headings_;
  }
  if (k >= table_->headings) {
    out.free_turned = !out.free_turned;
    k -= table_->headings;
  }
  out.entry = (static_cast<std::size_t>(i) * static_cast<std::size_t>(extent_ + 1) + static_cast<std::size_t>(j)) *
                  static_cast<std::size_t>(table_->headings) +
              static_cast<std::size_t>(k);
  return out;
}

bool PlanarWorkspace::reachable(int i, int j, int k) const { return table_->reachable[index(i, j, k)]; }

Coordinates PlanarWorkspace::conservative(int i, int j, int k) const {
  const Canonical at = canonical(i, j, k);
  const std::size_t position = at.entry / static_cast<std::size_t>(table_->headings);
  const int ci = static_cast<int>(position) / (extent_ + 1), cj = static_cast<int>(position) % (extent_ + 1);
  const int ck = static_cast<int>(at.entry % static_cast<std::size_t>(table_->headings));
  const auto inclined = table_->inclined.find(at.entry);
  Coordinates out = inclined != table_->inclined.end()
                        ? inclined->second
                        : table_->postures.coordinates(pose(ci, cj, ck), {static_cast<double>(table_->shift1[at.entry]),
                                                                          table_->backwards[at.entry] ? -1 : 1});
  // Undone in the opposite order: first the free foot's half turn, which only its own leg and hip feel.
  if (at.free_turned) {
    out.leg[1] = reversed(out.leg[1]);
    out.hip[1] += std::numbers::pi;
  }
  if (at.mirrored) out.hip = {-out.hip[0], -out.hip[1]};
  if (at.holding_turned) {
    out.leg[0] = reversed(out.leg[0]);
    out.hip[0] += std::numbers::pi;
  }
  out.hip = {wrapped(out.hip[0]), wrapped(out.hip[1])};
  return out;
}

std::optional<PlanarWorkspace> PlanarWorkspace::make(const Model& model, double position_step, double heading_step,
                                                     double clearance, const std::stop_token& stop, const Admit& admit) {
  PlanarWorkspace out;
  auto table = std::make_shared<Table>(model, clearance);
  out.table_ = table;
  out.position_step_ = position_step;
  out.headings_ = std::max(1, static_cast<int>(std::lround(2.0 * std::numbers::pi / heading_step)));
  out.heading_step_ = 2.0 * std::numbers::pi / out.headings_;
  out.extent_ = static_cast<int>(table->postures.greatest_reach() / position_step);
  table->headings = out.headings_ % 2 == 0 ? out.headings_ / 2 : out.headings_;
  const auto side = static_cast<std::size_t>(out.extent_ + 1), entry_headings = static_cast<std::size_t>(table->headings);
  table->shift1.resize(side * side * entry_headings);
  table->backwards.resize(table->shift1.size());
  std::vector<bool> entries(table->shift1.size());

  Exact exact(model, clearance);
  const double furthest = table->postures.greatest_reach();
  for (int i = 0; i <= out.extent_; ++i) {
    if (stop.stop_requested()) return std::nullopt;
    for (int j = 0; j <= out.extent_; ++j) {
      if (std::hypot(i, j) * position_step > furthest) break;
      for (int k = 0; k < table->headings; ++k) {
        const PlanarPose at = out.pose(i, j, k);
        const std::size_t entry = out.canonical(i, j, k).entry;
        const auto choice = table->postures.widest(at);
        if (choice && (!admit || admit(table->postures.coordinates(at, *choice)))) {
          table->shift1[entry] = static_cast<float>(choice->shift1);
          table->backwards[entry] = choice->side < 0;
          entries[entry] = true;
        } else if (2 * k % out.headings_ == 0) {
          const Reach inclined = exact.reach(to_isometry(at), admit);
          if (!inclined.reachable) continue;
          table->inclined.emplace(entry, *inclined.coordinates);
          entries[entry] = true;
        }
      }
    }
  }
  const int width = 2 * out.extent_ + 1;
  table->reachable.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(width) *
                          static_cast<std::size_t>(out.headings_));
  for (int i = -out.extent_; i <= out.extent_; ++i)
    for (int j = -out.extent_; j <= out.extent_; ++j)
      for (int k = 0; k < out.headings_; ++k) table->reachable[out.index(i, j, k)] = entries[out.canonical(i, j, k).entry];
  out.measure();
  return out;
}

void PlanarWorkspace::measure() {
  int most = 0;
  for (int i = -extent_; i <= extent_; ++i)
    for (int j = -extent_; j <= extent_; ++j) {
      int count = 0;
      for (int k = 0; k < headings_; ++k) count += reachable(i, j, k) ? 1 : 0;
      if (count == 0) continue;
      cells_.push_back({i, j, count});
      most = std::max(most, count);
      if (j == 0) r_max_ = std::max(r_max_, i * position_step_);
    }
  double sum = 0.0;
  int best = 0;
  for (const Cell& cell : cells_)
    if (cell.count == most) {
      sum += std::hypot(cell.i, cell.j) * position_step_;
      ++best;
    }
  if (best > 0) r_opt_ = sum / best;
}

}  // namespace foothold::hyrecro

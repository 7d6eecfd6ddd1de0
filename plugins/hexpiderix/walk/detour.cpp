// A* over stations.
#include "hexpiderix/walk/detour.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <queue>

namespace foothold::hexpiderix {
namespace {

constexpr double kGrid = 0.1;                // m
constexpr double kClosed = 0.12;             // m, round a place that is closed
constexpr std::size_t kMostStations = 3000;  // looked at in all

Vector3d on_ground(const Ground& ground, const Vector3d& place) {
  const auto height = ground.surface().height(place.x(), place.y());
  return {place.x(), place.y(), height.value_or(place.z())};
}

double cost_between(const Vector3d& a, const Vector3d& b) { return (b - a).head<2>().norm() + 2.0 * std::abs(b.z() - a.z()); }

// Headings turn evenly with the way.
std::vector<Station> with_headings(const std::vector<Vector3d>& places, double from, double to) {
  const double turned = std::remainder(to - from, 2.0 * std::numbers::pi);
  double length = 0.0;
  for (std::size_t k = 1; k < places.size(); ++k) length += (places[k] - places[k - 1]).head<2>().norm();
  std::vector<Station> out{{places.front(), from}};
  double way = 0.0;
  for (std::size_t k = 1; k < places.size(); ++k) {
    way += (places[k] - places[k - 1]).head<2>().norm();
    const double part = k + 1 == places.size() || length == 0.0 ? 1.0 : way / length;
    out.push_back({places[k], from + part * turned});
  }
  return out;
}

}  // namespace

std::vector<Station> straight_way(const Ground& ground, const Station& from, const Station& to) {
  const int count = std::max(1, static_cast<int>(std::ceil((to.place - from.place).head<2>().norm() / kGrid)));
  std::vector<Vector3d> places{from.place};
  for (int k = 1; k < count; ++k) places.push_back(on_ground(ground, from.place + k * (to.place - from.place) / count));
  places.push_back(to.place);
  return with_headings(places, from.heading, to.heading);
}

Detours::Detours(const Model& model, const Ground& ground, const Station& from, const Station& to, const WalkOptions& options)
    : model_(model), ground_(ground), from_(from), to_(to), options_(options) {}

const Detours::Place& Detours::place(const Cell& cell) {
  const auto known = places_.find(cell);
  if (known != places_.end()) return known->second;
  Place out{from_.place + kGrid * Vector3d(cell.first, cell.second, 0.0), false};
  if (const auto height = ground_.surface().height(out.at.x(), out.at.y())) {
    out.at.z() = *height;
    out.open = stand_at(model_, ground_, {out.at, from_.heading}, options_).has_value();
  }
  return places_.emplace(cell, out).first->second;
}

void Detours::close(const Vector3d& at) {
  const int reach = static_cast<int>(std::ceil(kClosed / kGrid)) + 1;
  const auto middle = [&](double to, double from) { return static_cast<int>(std::lround((to - from) / kGrid)); };
  const Cell around{middle(at.x(), from_.place.x()), middle(at.y(), from_.place.y())};
  for (int i = -reach; i <= reach; ++i)
    for (int j = -reach; j <= reach; ++j) {
      const Cell cell{around.first + i, around.second + j};
      if ((place(cell).at - at).head<2>().norm() < kClosed) places_.at(cell).open = false;
    }
}

std::vector<Station> Detours::find(const std::stop_token& stop) {
  struct Known {
    double cost;
    Cell before;
  };
  struct Entry {
    double total, cost;
    Cell cell;
    bool operator<(const Entry& other) const { return total != other.total ? total > other.total : cell > other.cell; }
  };
  const auto left = [&](const Vector3d& at) { return (to_.place - at).head<2>().norm(); };
  if (!stand_at(model_, ground_, to_, options_)) return {};
  std::map<Cell, Known> known{{{0, 0}, {0.0, {0, 0}}}};
  std::priority_queue<Entry> open;
  open.push({left(from_.place), 0.0, {0, 0}});
  while (!open.empty() && places_.size() < kMostStations && !stop.stop_requested()) {
    const Entry now = open.top();
    open.pop();
    if (now.cost > known.at(now.cell).cost) continue;
    const Vector3d at = now.cell == Cell{0, 0} ? from_.place : place(now.cell).at;
    if (left(at) < kGrid) {
      std::vector<Vector3d> places{to_.place};
      for (Cell cell = now.cell; cell != Cell{0, 0}; cell = known.at(cell).before) places.push_back(place(cell).at);
      places.push_back(from_.place);
      std::reverse(places.begin(), places.end());
      return with_headings(places, from_.heading, to_.heading);
    }
    for (int i = -1; i <= 1; ++i)
      for (int j = -1; j <= 1; ++j) {
        const Cell next{now.cell.first + i, now.cell.second + j};
        if ((i == 0 && j == 0) || !place(next).open) continue;
        const double cost = now.cost + cost_between(at, place(next).at);
        const auto before = known.find(next);
        if (before != known.end() && before->second.cost <= cost) continue;
        known[next] = {cost, now.cell};
        open.push({cost + left(place(next).at), cost, next});
      }
  }
  return {};
}

}  // namespace foothold::hexpiderix

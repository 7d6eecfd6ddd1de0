// The removal of useless sections, and the last trimming.
#include "bioloid/paper/sections.hpp"

#include <cmath>
#include <map>

namespace foothold::bioloid::paper {
namespace {

// Equal points have equal keys but for rounding across a border, where a loop is left to the second look.
std::vector<std::int64_t> key(const Space& space, const Point& point) {
  std::vector<std::int64_t> out(static_cast<std::size_t>(point.size()));
  for (int k = 0; k < point.size(); ++k)
    out[static_cast<std::size_t>(k)] = std::llround((point[k] - space.low[k]) / space.step[k] * 1e5);
  return out;
}

std::vector<Point> without_loops(const Space& space, const std::vector<Point>& path) {
  std::map<std::vector<std::int64_t>, std::size_t> last;
  for (std::size_t k = 0; k < path.size(); ++k) last[key(space, path[k])] = k;
  std::vector<Point> out;
  for (std::size_t k = 0; k < path.size(); ++k) {
    k = last[key(space, path[k])];
    out.push_back(out.empty() ? path.front() : path[k]);
  }
  return out;
}

bool one_iteration(const Space& space, const Point& a, const Point& b) {
  return ((b - a).cwiseAbs().array() <= (1.0 + 1e-6) * space.step.array()).all();
}

}  // namespace

std::vector<Point> without_useless_sections(const Space& space, const std::vector<Point>& path, std::stop_token stop) {
  const std::vector<Point> simple = without_loops(space, path);
  std::vector<Point> out;
  for (std::size_t k = 0; k < simple.size(); ++k) {
    out.push_back(simple[k]);
    if (stop.stop_requested()) continue;
    std::size_t to = simple.size() - 1;
    while (to > k + 1 && !(one_iteration(space, simple[k], simple[to]) && space.moves(simple[k], simple[to]))) --to;
    if (to > k + 1) k = to - 1;
  }
  return out;
}

std::vector<Point> trimmed(const Space& space, const std::vector<Point>& path, std::stop_token stop) {
  std::vector<Point> places;
  places.reserve(path.size());
  for (const Point& point : path) places.push_back(space.place ? space.place(point) : point);
  std::vector<Point> out;
  for (std::size_t k = 0; k < path.size(); ++k) {
    out.push_back(path[k]);
    if (stop.stop_requested()) continue;
    const auto cut_to = [&](std::size_t to) {
      return (places[to] - places[k]).norm() <= space.equal && (same(space, path[k], path[to]) || space.moves(path[k], path[to]));
    };
    std::size_t to = path.size() - 1;
    while (to > k && !cut_to(to)) --to;
    // The same joints again: the later point stands for both. Else it follows by one movement.
    if (to > k) k = same(space, path[k], path[to]) ? to : to - 1;
  }
  return out;
}

}  // namespace foothold::bioloid::paper

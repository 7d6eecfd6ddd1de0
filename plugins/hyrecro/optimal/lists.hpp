// Which transition footholds may be reached from which, whatever the scene: found line by line, kept, and shared by what is alike.
//
// Transition footholds lie on lines, with one heading each. Between two parallel lines the pose of one foothold seen from another
// depends on the distance along the lines alone, so it is judged once for each distance, by ReachFilter. Poses that pass are
// numbered as kinds: what exact reachability later says of one holds for all of its kind.
#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "hyrecro/optimal/search.hpp"
#include "hyrecro/reach/reach_filter.hpp"
#include "hyrecro/scene/transitions.hpp"

namespace foothold::hyrecro {

class TransitionLists {
 public:
  // `reach`: no two soles are further apart, m. Borrows all of them.
  TransitionLists(const Transitions& transitions, const ReachFilter& filter, double reach);

  using Entry = RouteGraph::Transition;
  // Of one transition foothold; what exclude() took out is not in it. Valid until the next call of anything here.
  const std::vector<Entry>& of(int foothold);
  // The same for a sole that stands elsewhere, on `face`; kinds are -1.
  std::vector<Entry> around(const Isometry3d& sole, int face);
  // They are out of reach of each other after all, and all that are alike.
  void exclude_alike(int one, int other);
  // The scene forbids this one.
  void exclude(int one, int other);
  std::size_t entries() const { return entries_; }  // in all lists

 private:
  struct Line {
    int face = -1;
    Vector3d origin = Vector3d::Zero(), along = Vector3d::Zero();  // world, of the first foothold's place
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
    std::vector<int> footholds;
    std::vector<double> places;  // m along the line, rising
  };
  struct Cell {
    int x = 0, y = 0, z = 0;
    bool operator==(const Cell&) const = default;
  };
  struct CellHash {
    std::size_t operator()(const Cell& cell) const;
  };
  using Key = std::array<std::int32_t, 9>;
  struct KeyHash {
    std::size_t operator()(const Key& key) const;
  };
  Cell cell_of(const Vector3d& point) const;
  void make_lines();
  void list(int line);
  void pair(const Line& from, const Line& to);
  std::vector<int> lines_near(const Vector3d& point) const;
  int kind_of(const Isometry3d& pose);
  const ReachFilter::Turn& turn_of(const Eigen::Matrix3d& orientation);  // valid until the next call

  const Transitions* transitions_;
  const ReachFilter* filter_;
  double reach_;
  std::vector<Line> lines_;
  std::vector<int> line_of_;                                    // by foothold
  std::unordered_map<Cell, std::vector<int>, CellHash> cells_;  // lines by the cells that they touch
  std::vector<char> listed_;                                    // by line
  std::vector<std::vector<Entry>> lists_;                       // by foothold
  std::vector<std::uint32_t> cleaned_;                          // by foothold: how many kinds were excluded then
  std::unordered_map<Key, ReachFilter::Turn, KeyHash> turns_;   // by orientation
  std::unordered_map<Key, int, KeyHash> kinds_;
  std::vector<char> excluded_;  // by kind
  std::uint32_t exclusions_ = 0;
  std::size_t entries_ = 0;
};

}  // namespace foothold::hyrecro

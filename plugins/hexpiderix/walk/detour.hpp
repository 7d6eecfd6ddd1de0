// Ways round what cannot be walked over: stations on a grid at which the robot can stand on six feet.
#pragma once

#include <map>
#include <stop_token>
#include <utility>
#include <vector>

#include "hexpiderix/walk/walk.hpp"

namespace foothold::hexpiderix {

// From `from` to `to` in a straight line, a station on the ground at every grid's width; headings turn evenly.
std::vector<Station> straight_way(const Ground& ground, const Station& from, const Station& to);

// One thread at a time; what it learns of the ground it keeps for the next way.
class Detours {
 public:
  Detours(const Model& model, const Ground& ground, const Station& from, const Station& to, const WalkOptions& options);

  // The shortest way over stations of the grid (A*, eight neighbours); steps up and down count twice. Empty if there is none that
  // avoids what is closed, or after kMostStations stations, or when stop is requested.
  std::vector<Station> find(const std::stop_token& stop);
  // No way leads near this place any more.
  void close(const Vector3d& place);

 private:
  using Cell = std::pair<int, int>;  // of the grid round `from`
  struct Place {
    Vector3d at;
    bool open;
  };
  const Place& place(const Cell& cell);

  const Model& model_;
  const Ground& ground_;
  Station from_, to_;
  const WalkOptions& options_;
  std::map<Cell, Place> places_;
};

}  // namespace foothold::hexpiderix

// A truss as the search sees it: the scene's transition footholds, start and goal; legs and transitions judged when asked for, and
// kept for later requests of the same scene.
#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "hyrecro/optimal/legs.hpp"
#include "hyrecro/optimal/lists.hpp"
#include "hyrecro/optimal/optimal.hpp"
#include "hyrecro/optimal/search.hpp"
#include "hyrecro/reach/reach_filter.hpp"

namespace foothold::hyrecro {

// m: at most so much is added to the length of a transition for each of its ends, to tell equally long routes apart.
inline constexpr double kPreference = 1e-7;

inline constexpr std::size_t kMostListed = 50'000;

// What later requests find again. Transition footholds by their index in Transitions::all().
struct KeptTruss final : PreparedTruss::Kept {
  KeptTruss(const Model& model, const PreparedTruss& scene);

  struct Leg {
    int least = 0;  // strides: proved
    bool found = false;
    std::vector<Stride> strides;
  };
  // Least strides of legs from a foothold to each of its face.
  const std::vector<std::uint8_t>& row(int foothold);
  const Advances& advances_of(int foothold);
  TransitionLists& lists();  // made when first asked for
  // Not so many footholds that rows and lists of all of them take gigabytes.
  bool listable() const { return places.size() <= kMostListed; }
  // Bounds what is kept; to be called between requests.
  void tidy();

  // See search_large().
  bool large() const { return scene.portals.has_value(); }

  const PreparedTruss& scene;
  Strides strides;
  Legs legs;
  std::shared_ptr<const ReachFilter> filter;
  std::vector<Vector3d> places;                                          // m, world, by foothold
  std::vector<signed char> footing;                                      // by foothold: see Legs::has_footing(); -1: not known
  std::unordered_map<std::uint64_t, std::optional<Coordinates>> judged;  // transitions by both ends, with the scene
  std::unordered_map<std::uint64_t, Leg> walked;                         // legs by both ends

 private:
  std::vector<std::vector<std::uint8_t>> rows_;
  std::vector<Advances> advances_;  // by foothold; below 0: not known
  std::size_t in_rows_ = 0;
  std::optional<TransitionLists> lists_;
};

// Empty without bans. Borrows `bans`.
Banned banned_by(const std::vector<Ban>& bans);

// Borrows everything. One request's view. Node numbers: transition footholds, then start, then goal.
class TrussGraph final : public RouteGraph {
 public:
  TrussGraph(const Model& model, const PreparedTruss& scene, KeptTruss& kept, const Foothold& start, const Foothold& goal,
             const OptimalOptions& options);

  int nodes() const override { return samples_ + 2; }
  int start() const override { return samples_; }
  int goal() const override { return samples_ + 1; }
  int face_of(int node) const override { return at(node).face; }
  std::span<const int> on_face(int face) const override;
  void leg_bounds(int node, std::span<Cost> out) override;
  Cost leg(int from, int to, bool proved) override;
  bool achieve(int from, int to) override;
  std::array<std::span<const Transition>, 2> transitions(int node) override;
  Cost cost(int node, const Transition& transition) const override;
  bool counts() const override { return options_.objective == Objective::kSteps; }
  bool transition(int from, int to) override;
  std::size_t patience() const override { return 20'000; }
  void leg_firsts(int node, std::span<double> out) override;
  double from_start(int node) override;
  double second_to_goal(int node) override;

  const Foothold& at(int node) const;
  // Whether any stride leads away from `end`, start or goal. A quick look before a search that may be long.
  bool hemmed_in(int end);
  const Banned& banned() const { return banned_; }
  // Whether legs were taken to fail for others that had (see barred()); from stop_guessing() on none is.
  bool guessed() const { return guessed_; }
  void stop_guessing() { guesses_ = false; }
  // Whether a stride leads to the node's foothold from around it, as far as a quick look tells.
  bool footing(int node);
  const Vector3d& place(int node) const;  // m, world
  // Of a hop that leg() or transition() has found possible.
  std::vector<Stride> strides_of(const Hop& hop);

 private:
  Cost of(int strides, double length) const;
  Isometry3d pose(int node) const;
  using Walked = std::unordered_map<std::uint64_t, KeptTruss::Leg>;
  const KeptTruss::Leg& walk(int from, int to);
  const KeptTruss::Leg& walk(int from, int to, const Banned& banned, Walked& known);
  const std::optional<Coordinates>& judge(int from, int to);
  void list_own(int end);
  const std::vector<Transition>& own_list(int node);
  bool barred(int from, int to) const;
  void tell(int from, int to, bool found);
  std::uint32_t corner(int node) const;
  const std::vector<std::uint8_t>* row_of(int node);
  const Advances& advances_of(int node) {
    return node < samples_ ? kept_.advances_of(node) : own_advances_[node == start() ? 0 : 1];
  }
  int least(int node, const std::vector<std::uint8_t>* row, std::size_t index, int other);

  const Model& model_;
  const PreparedTruss& scene_;
  KeptTruss& kept_;
  Foothold start_, goal_;
  const OptimalOptions& options_;
  Banned banned_;
  int samples_;
  std::vector<int> start_face_, goal_face_;  // nodes there, with start and goal
  std::array<signed char, 2> own_footing_{-1, -1};
  std::array<Advances, 2> own_advances_;
  std::array<Vector3d, 2> own_places_;  // of start and goal
  std::unordered_map<int, std::vector<Transition>>
      own_lists_;      // of start and goal; of footholds: those two alone; made when first asked for
  Walked own_walked_;  // legs with start or goal
  Walked round_bans_;  // where bans take strides out of them
  std::unordered_map<std::uint64_t, std::optional<Coordinates>> own_judged_;
  Walked achieved_;                                  // in fewer strides than walk() finds
  std::unordered_map<std::uint64_t, int> doubtful_;  // legs that were not achieved with so many strides
  bool guesses_ = true, guessed_ = false;
  std::unordered_map<std::uint64_t, int> failures_;  // of legs: between two corners of a face, from one, to one
};

}  // namespace foothold::hyrecro

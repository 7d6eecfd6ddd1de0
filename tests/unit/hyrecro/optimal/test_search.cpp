// The search over legs and transitions against Bellman and Ford on small random graphs, with bounds that are too low.
#include "hyrecro/optimal/search.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>

namespace foothold::hyrecro {
namespace {

class RandomGraph final : public RouteGraph {
 public:
  // `hard`: some legs are found by achieve() alone.
  explicit RandomGraph(std::uint64_t seed, bool hard = false) : random_(seed) {
    const int faces = 2 + some(5);
    faces_.resize(static_cast<std::size_t>(faces));
    for (int node = 0; node < nodes(); ++node) {
      const int face = some(faces);
      face_.push_back(face);
      place_.push_back(some(12));
      faces_[static_cast<std::size_t>(face)].push_back(node);
    }
    lists_.resize(static_cast<std::size_t>(nodes()));
    for (int a = 0; a < nodes(); ++a)
      for (int b = a + 1; b < nodes(); ++b) {
        if (face_[index(a)] == face_[index(b)]) {
          const double more = some(3) == 0 ? some(4) : 0;
          legs_[{a, b}] = legs_[{b, a}] = some(8) == 0 ? kNever : bound(a, b) + Cost{more, 0.0};
          proved_[{a, b}] = proved_[{b, a}] = some(2) == 0 && !(legs_[{a, b}] == kNever) ? legs_[{a, b}] : bound(a, b);
          if (hard && some(4) == 0) hidden_[{a, b}] = hidden_[{b, a}] = proved_[{a, b}];
        } else if (some(14) == 0) {
          const double distance = 1 + some(3);
          lists_[index(a)].push_back({b, -1, distance});
          lists_[index(b)].push_back({a, -1, distance});
          possible_[{a, b}] = possible_[{b, a}] = some(3) > 0;
        }
      }
  }

  int nodes() const override { return 24; }
  int start() const override { return 0; }
  int goal() const override { return 1; }
  int face_of(int node) const override { return face_[index(node)]; }
  std::span<const int> on_face(int face) const override { return faces_[index(face)]; }
  void leg_bounds(int node, std::span<Cost> out) override {
    const auto there = on_face(face_of(node));
    for (std::size_t i = 0; i < there.size(); ++i) out[i] = bound(node, there[i]);
  }
  Cost leg(int from, int to, bool proved) override {
    if (!proved) return legs_.at({from, to});
    const auto doubted = doubted_.find({from, to});
    return doubted == doubted_.end() ? proved_.at({from, to}) : doubted->second;
  }
  bool achieve(int from, int to) override {
    const Cost wanted = leg(from, to, true);
    if (const auto hidden = hidden_.find({from, to}); hidden != hidden_.end() && hidden->second < legs_.at({from, to}))
      legs_[{from, to}] = hidden->second;
    if (!(wanted < legs_.at({from, to}))) return true;
    doubted_[{from, to}] = wanted + Cost{1.0, 0.0};
    return false;
  }
  std::array<std::span<const Transition>, 2> transitions(int node) override {
    const std::span<const Transition> all = lists_[index(node)];
    return {all.first(all.size() / 2), all.subspan(all.size() / 2)};
  }
  Cost cost(int, const Transition& transition) const override { return {1.0, transition.distance}; }
  bool counts() const override { return true; }
  std::size_t patience() const override { return 20'000; }
  bool transition(int from, int to) override { return possible_.at({from, to}); }
  void leg_firsts(int node, std::span<double> out) override {
    const auto there = on_face(face_of(node));
    for (std::size_t i = 0; i < there.size(); ++i) out[i] = bound(node, there[i]).first;
  }
  double from_start(int) override { return 0.0; }
  double second_to_goal(int) override { return 0.0; }

  // Everything that can be found.
  void show() {
    for (const auto& [ends, cost] : hidden_) legs_[ends] = std::min(legs_[ends], cost);
  }

  // Least cost by relaxing every edge until nothing changes; `lower`: with what is proved of legs instead of what is true.
  Cost least(bool lower) const {
    std::vector<Cost> arrived(index(nodes()), kNever), departing(index(nodes()), kNever);
    arrived[index(start())] = {};
    for (bool changed = true; changed;) {
      changed = false;
      const auto relax = [&](Cost& at, const Cost& cost) {
        if (cost < at) at = cost, changed = true;
      };
      for (int a = 0; a < nodes(); ++a) {
        if (!(arrived[index(a)] == kNever))
          for (const int b : on_face(face_of(a)))
            relax(departing[index(b)], arrived[index(a)] + (a == b ? Cost{} : (lower ? proved_ : legs_).at({a, b})));
        if (!(departing[index(a)] == kNever))
          for (const Transition& t : lists_[index(a)])
            if (possible_.at({a, t.to})) relax(arrived[index(t.to)], departing[index(a)] + cost(a, t));
      }
    }
    return departing[index(goal())];
  }
  // Cost of hops, as it truly is.
  Cost of(const std::vector<Hop>& hops) const {
    Cost out;
    int at = start();
    for (const Hop& hop : hops) {
      EXPECT_EQ(hop.from, at);
      at = hop.to;
      if (hop.leg) {
        out = out + legs_.at({hop.from, hop.to});
        continue;
      }
      EXPECT_TRUE(possible_.at({hop.from, hop.to}));
      for (const Transition& t : lists_[index(hop.from)])
        if (t.to == hop.to) out = out + cost(hop.from, t);
    }
    EXPECT_EQ(at, goal());
    return out;
  }

 private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  int some(int below) { return static_cast<int>(random_() % static_cast<std::uint64_t>(below)); }
  Cost bound(int a, int b) const {
    const double distance = std::abs(place_[index(a)] - place_[index(b)]);
    return a == b ? Cost{} : Cost{std::max(1.0, std::ceil(distance / 3.0)), distance};
  }

  std::mt19937_64 random_;
  std::vector<int> face_, place_;
  std::vector<std::vector<int>> faces_;
  std::vector<std::vector<Transition>> lists_;
  std::map<std::pair<int, int>, Cost> legs_, proved_, hidden_, doubted_;
  std::map<std::pair<int, int>, bool> possible_;
};

TEST(SearchRoute, FindsTheLeastCostOfRandomGraphsAndItsBound) {
  int found = 0, none = 0, above = 0;
  for (std::uint64_t seed = 0; seed < 3000; ++seed) {
    RandomGraph graph(seed);
    const SearchResult result = search_route(graph, 1'000'000, {});
    const Cost least = graph.least(false);
    if (least == kNever) {
      ++none;
      ASSERT_EQ(result.outcome, SearchResult::Outcome::kNone) << "seed " << seed;
      continue;
    }
    ++found;
    ASSERT_EQ(result.outcome, SearchResult::Outcome::kFound) << "seed " << seed;
    ASSERT_TRUE(result.cost == least) << "seed " << seed << ": " << result.cost.first << " instead of " << least.first;
    ASSERT_TRUE(graph.of(result.hops) == least) << "seed " << seed;
    const double proved = graph.least(true).first;
    ASSERT_LE(result.bound.first, least.first) << "seed " << seed;
    ASSERT_EQ(result.bound.first, proved) << "seed " << seed;
    above += result.bound.first < least.first ? 1 : 0;
  }
  EXPECT_GT(found, 1000);
  EXPECT_GT(none, 100);
  EXPECT_GT(above, 100);
}

TEST(SearchRoute, LooksHarderForLegsThatNoProofContradicts) {
  int better = 0, least_of_all = 0, found = 0;
  for (std::uint64_t seed = 0; seed < 3000; ++seed) {
    RandomGraph graph(seed, true);
    const Cost easy = graph.least(false);
    const SearchResult result = search_route(graph, 1'000'000, {});
    if (result.outcome != SearchResult::Outcome::kFound) continue;
    ++found;
    ASSERT_FALSE(easy < result.cost) << "seed " << seed;
    ASSERT_EQ(graph.of(result.hops).first, result.cost.first) << "seed " << seed;
    ASSERT_LE(result.bound.first, graph.least(true).first) << "seed " << seed;
    graph.show();
    const double least = graph.least(false).first;
    ASSERT_LE(least, result.cost.first) << "seed " << seed;
    ASSERT_LE(result.bound.first, least) << "seed " << seed;
    better += result.cost.first < easy.first ? 1 : 0;
    least_of_all += result.cost.first == least ? 1 : 0;
  }
  EXPECT_GT(better, 50);
  EXPECT_GT(least_of_all, 0.95 * found);
}

TEST(SearchRoute, GivesUpAtTheLimitAndStopsWhenAsked) {
  RandomGraph graph(3);
  EXPECT_EQ(search_route(graph, 1, {}).outcome, SearchResult::Outcome::kLimit);
  std::stop_source source;
  source.request_stop();
  EXPECT_EQ(search_route(graph, 1000, source.get_token()).outcome, SearchResult::Outcome::kStopped);
}

}  // namespace
}  // namespace foothold::hyrecro

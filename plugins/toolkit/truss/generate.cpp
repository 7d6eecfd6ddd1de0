// Members between nodes, grown from the first one until there are enough.
#include "truss/generate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <stdexcept>

namespace foothold::truss {
namespace {

double to_millimetres(double length) { return std::round(length * 1000.0) / 1000.0; }

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : random_(seed) {}
  // Multiples of `step` (m) in [low, high].
  double length(double low, double high, double step = 0.001) {
    const auto count = static_cast<std::uint64_t>(std::llround((high - low) / step)) + 1;
    return to_millimetres(low + step * static_cast<double>(whole(count)));
  }
  std::uint64_t whole(std::uint64_t count) { return random_() % count; }  // 0 to count - 1; the bias is below 2^-50

 private:
  std::mt19937_64 random_;
};

struct Profile {
  double width, height;
};

Profile profile(Draw& draw) {
  const double width = draw.length(0.12, 0.30, 0.005);
  return {width, draw.whole(2) == 0 ? width : draw.length(0.12, 0.30, 0.005)};
}

// A beam from one node to another, through others if it is a column, leg or chord.
struct Member {
  std::string name;
  std::vector<int> nodes;
  Profile profile;
  Vector3d up;
};

struct Frame {
  std::vector<Vector3d> nodes;
  std::vector<Member> members;

  void add(std::string name, std::vector<int> through, const Profile& profile, const Vector3d& up) {
    members.push_back({std::move(name), std::move(through), profile, up});
  }
};

// "girder 1-2-3"; what is not given (-1) is left out. Counted from 1.
std::string numbered(const char* word, int a, int b = -1, int c = -1) {
  std::string out = word + (" " + std::to_string(a + 1));
  for (const int k : {b, c})
    if (k >= 0) out += "-" + std::to_string(k + 1);
  return out;
}

// Frames side by side along Y, each with bays along X and storeys along Z, joined by purlins.
Frame portal(Draw& draw, int beams) {
  int bays = 1 + static_cast<int>(draw.whole(4)), storeys = 1 + static_cast<int>(draw.whole(3)), frames = 1;
  const auto count = [&] { return frames * (bays + 1 + storeys) + (frames > 1 ? (bays + 1) * storeys : 0); };
  while (count() < beams) ++(frames <= bays ? frames : bays);
  std::vector<double> x{0.0}, y{0.0}, z{0.0};
  for (int i = 0; i < bays; ++i) x.push_back(to_millimetres(x.back() + draw.length(1.2, 2.5)));
  for (int j = 1; j < frames; ++j) y.push_back(to_millimetres(y.back() + draw.length(1.2, 2.5)));
  for (int k = 0; k < storeys; ++k) z.push_back(to_millimetres(z.back() + draw.length(1.2, 2.2)));
  const Profile column = profile(draw), girder = profile(draw), purlin = profile(draw);
  Frame out;
  const auto node = [&](int i, int j, int k) { return (j * (bays + 1) + i) * (storeys + 1) + k; };
  for (int j = 0; j < frames; ++j)
    for (int i = 0; i <= bays; ++i)
      for (int k = 0; k <= storeys; ++k)
        out.nodes.emplace_back(x[static_cast<std::size_t>(i)], y[static_cast<std::size_t>(j)], z[static_cast<std::size_t>(k)]);
  for (int j = 0; j < frames; ++j) {
    for (int k = 1; k <= storeys; ++k) {
      std::vector<int> through;
      for (int i = 0; i <= bays; ++i) through.push_back(node(i, j, k));
      out.add(numbered("girder", j, k - 1), through, girder, Vector3d::UnitZ());
    }
    for (int i = 0; i <= bays; ++i) {
      std::vector<int> through;
      for (int k = 0; k <= storeys; ++k) through.push_back(node(i, j, k));
      out.add(numbered("column", j, i), through, column, Vector3d::UnitX());
      for (int k = 1; j == 0 && frames > 1 && k <= storeys; ++k) {
        std::vector<int> along;
        for (int other = 0; other < frames; ++other) along.push_back(node(i, other, k));
        out.add(numbered("purlin", i, k - 1), along, purlin, Vector3d::UnitZ());
      }
    }
  }
  return out;
}

// Four legs; on each level a ring, in each field of each side a diagonal.
Frame tower(Draw& draw, int beams) {
  const int levels = std::max(1, (beams - 4 + 7) / 8);
  const double base = draw.length(1.4, 2.4), taper = 0.01 * static_cast<double>(draw.whole(41));
  std::vector<double> z{0.0};
  for (int k = 0; k < levels; ++k) z.push_back(to_millimetres(z.back() + draw.length(1.2, 2.0)));
  const Profile leg = profile(draw), ring = profile(draw), diagonal = profile(draw);
  const bool turned = draw.whole(2) == 0;
  Frame out;
  constexpr std::array<std::array<int, 2>, 4> kCorner{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
  for (int k = 0; k <= levels; ++k) {
    // In proportion to the height, or the nodes of a leg would not lie on one line.
    const double half = 0.5 * base * (1.0 - taper * z[static_cast<std::size_t>(k)] / z.back());
    for (const auto& corner : kCorner) out.nodes.emplace_back(half * corner[0], half * corner[1], z[static_cast<std::size_t>(k)]);
  }
  for (int c = 0; c < 4; ++c) {
    std::vector<int> through;
    for (int k = 0; k <= levels; ++k) through.push_back(4 * k + c);
    out.add(numbered("leg", c), through, leg, Vector3d::UnitX());
  }
  for (int k = 1; k <= levels; ++k)
    for (int c = 0; c < 4; ++c) {
      const int next = (c + 1) % 4;
      out.add(numbered("ring", k - 1, c), {4 * k + c, 4 * k + next}, ring, Vector3d::UnitZ());
      const bool rising = (k % 2 == 0) == turned;
      out.add(numbered("diagonal", k - 1, c), {4 * (k - 1) + (rising ? c : next), 4 * k + (rising ? next : c)}, diagonal,
              Vector3d::UnitZ());
    }
  return out;
}

// Two lattice girders along X, joined below and above.
Frame bridge(Draw& draw, int beams) {
  const int bays = std::max(1, (beams - 8 + 5) / 6);
  const double width = draw.length(1.2, 2.2), height = draw.length(1.2, 2.2);
  std::vector<double> x{0.0};
  for (int i = 0; i < bays; ++i) x.push_back(to_millimetres(x.back() + draw.length(1.2, 2.2)));
  const Profile chord = profile(draw), post = profile(draw), diagonal = profile(draw), cross = profile(draw);
  const bool turned = draw.whole(2) == 0;
  Frame out;
  for (const double at : x)
    for (int side = 0; side < 2; ++side)
      for (int level = 0; level < 2; ++level) out.nodes.emplace_back(at, side * width, level * height);
  const auto node = [](int i, int side, int level) { return 4 * i + 2 * side + level; };
  for (int side = 0; side < 2; ++side)
    for (int level = 0; level < 2; ++level) {
      std::vector<int> through;
      for (int i = 0; i <= bays; ++i) through.push_back(node(i, side, level));
      out.add(numbered("chord", side, level), through, chord, Vector3d::UnitZ());
    }
  for (int i = 0; i <= bays; ++i) {
    for (int side = 0; side < 2; ++side) {
      out.add(numbered("post", i, side), {node(i, side, 0), node(i, side, 1)}, post, Vector3d::UnitX());
      const int from = (i % 2 == 0) == turned ? 0 : 1;
      if (i < bays)
        out.add(numbered("diagonal", i, side), {node(i, side, from), node(i + 1, side, 1 - from)}, diagonal, Vector3d::UnitZ());
    }
    for (int level = 0; level < 2; ++level)
      out.add(numbered("cross", i, level), {node(i, 0, level), node(i, 1, level)}, cross, Vector3d::UnitZ());
  }
  return out;
}

}  // namespace

std::optional<Family> family_named(std::string_view name) {
  if (name == "portal") return Family::kPortal;
  if (name == "tower") return Family::kTower;
  if (name == "bridge") return Family::kBridge;
  return std::nullopt;
}

Layout generate(Family family, std::uint64_t seed, int beams) {
  if (beams < kFewestBeams || beams > kMostBeams) throw std::invalid_argument("a truss is made of 2 to 2000 beams");
  Draw draw(seed);
  Frame frame = family == Family::kPortal  ? portal(draw, beams)
                : family == Family::kTower ? tower(draw, beams)
                                           : bridge(draw, beams);
  const char* name = family == Family::kPortal ? "portal frame" : family == Family::kTower ? "lattice tower" : "bridge bays";
  Layout out;
  out.description = std::string(name) + " of " + std::to_string(beams) + " beams, seed " + std::to_string(seed);
  // Always the first member that is joined to what is there already.
  std::vector<bool> there(frame.nodes.size(), false);
  std::vector<bool> taken(frame.members.size(), false);
  for (std::size_t begin = 0, k = 0; out.beams.size() < static_cast<std::size_t>(beams);) {
    const Member& member = frame.members[k];
    const bool joined = out.beams.empty() || std::any_of(member.nodes.begin(), member.nodes.end(),
                                                         [&](int n) { return there[static_cast<std::size_t>(n)]; });
    if (taken[k] || !joined) {
      ++k;
      continue;
    }
    taken[k] = true;
    for (const int n : member.nodes) there[static_cast<std::size_t>(n)] = true;
    out.beams.push_back({member.name, frame.nodes[static_cast<std::size_t>(member.nodes.front())],
                         frame.nodes[static_cast<std::size_t>(member.nodes.back())], member.profile.width, member.profile.height,
                         member.up});
    while (begin < taken.size() && taken[begin]) ++begin;
    k = begin;
  }
  return out;
}

}  // namespace foothold::truss

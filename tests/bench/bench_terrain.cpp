// Rough terrain: reading, checks, cutting, the tree, and what robots ask of it: bench_terrain [--quick].
//
// The paper's ramps (cut to 0.2 m: 1116 triangles) and boulders of 100,352 triangles as binary STL. Times are this thread's CPU
// time, so that what else the machine does counts little; of several runs the least. The baseline of a foothold is the paper's own
// search among centroids within 1.5 R (Molla-Santamaria et al. 2023, section 3), which may also miss the nearest triangle.
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <random>

#include "figures.hpp"
#include "terrain/centroids.hpp"
#include "terrain/generate.hpp"
#include "terrain/surface.hpp"

namespace {

using namespace foothold;
using namespace foothold::bench;
using terrain::Surface;
using terrain::Terrain;
using terrain::Vector3d;

std::filesystem::path as_binary_stl(const Terrain& terrain) {
  const auto path = std::filesystem::temp_directory_path() / ("bench_terrain_" + std::to_string(getpid()) + ".stl");
  std::ofstream file(path, std::ios::binary);
  file << std::string(80, ' ');
  const auto write = [&](const auto& value) { file.write(reinterpret_cast<const char*>(&value), sizeof(value)); };
  write(static_cast<std::uint32_t>(terrain.size()));
  for (int t = 0; t < static_cast<int>(terrain.size()); ++t) {
    for (int k = -1; k < 3; ++k)
      for (Eigen::Index axis = 0; axis < 3; ++axis) write(k < 0 ? 0.0F : static_cast<float>(terrain.corner(t, k)[axis]));
    write(std::uint16_t{0});
  }
  return path;
}

// From 0.05 m under the ground to 0.15 m above it, where feet and bodies are.
std::vector<Vector3d> points_near(const Surface& surface, double half, std::size_t count) {
  std::mt19937_64 random(1);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1.0p-53;
  };
  std::vector<Vector3d> out;
  while (out.size() < count) {
    const double x = uniform(-half, half), y = uniform(-half, half);
    if (const auto z = surface.height(x, y)) out.emplace_back(x, y, *z + uniform(-0.05, 0.15));
  }
  return out;
}

double sink = 0.0;  // so that nothing measured is left out

void ask(const std::string& name, const Terrain& terrain, double half, int runs, std::vector<Figure>& out) {
  const Surface surface(terrain);
  const terrain::CentroidTree centroids(terrain);
  const std::vector<Vector3d> points = points_near(surface, half, 20000);
  const auto each = [&](auto&& question) {
    const double all = least_seconds(runs, [&] {
      for (const Vector3d& p : points) sink += question(p);
    });
    return 1e9 * all / static_cast<double>(points.size());
  };
  const double paper = each([&](const Vector3d& p) { return static_cast<double>(centroids.foothold(p, p, 0.3).triangle); });
  const double nearest = each([&](const Vector3d& p) { return surface.nearest(p).distance; });
  out.push_back({name + "_nearest", nearest, "ns", "less", std::nullopt, paper, "the paper's search among centroids"});
  out.push_back({name + "_beneath", each([&](const Vector3d& p) { return surface.beneath(p) ? 1.0 : 0.0; }), "ns", "less"});
  out.push_back(
      {name + "_ten_nodes", each([&](const Vector3d& p) { return centroids.nearest(p, 10).back() + 0.0; }), "ns", "less"});
  const Vector3d leg(0.05, 0.05, 0.07);
  out.push_back({name + "_capsule", each([&](const Vector3d& p) {
                   return surface.nearer(terrain::Capsule{p, p + leg, 0.01}, 0.0) ? 1.0 : 0.0;
                 }),
                 "ns", "less"});
}

}  // namespace

int main(int count, char** words) {
  const int runs = quick(count, words) ? 3 : 15;
  std::vector<Figure> figures;
  const Terrain ramps = terrain::ramps(), fine = terrain::subdivide(ramps, 0.2);
  const Terrain boulders = terrain::generate(terrain::Family::kBoulders, {1, 22.4, 0.1});
  const auto path = as_binary_stl(boulders);
  const auto milliseconds = [&](const std::string& name, auto&& work) {
    figures.push_back({name, 1e3 * least_seconds(runs, [&] { sink += static_cast<double>(work()); }), "ms", "less"});
  };
  milliseconds("ramps_cut", [&] { return terrain::subdivide(ramps, 0.2).size(); });
  milliseconds("ramps_tree", [&] { return Surface(fine).terrain().size(); });
  milliseconds("large_read", [&] { return terrain::read_terrain(path.string()).size(); });
  milliseconds("large_cut_midpoint", [&] { return terrain::subdivide(boulders, 0.06).size(); });
  milliseconds("large_cut_longest_side", [&] { return terrain::subdivide(boulders, 0.06, terrain::Split::kLongestSide).size(); });
  milliseconds("large_tree", [&] { return Surface(boulders).terrain().size(); });
  std::filesystem::remove(path);
  ask("ramps", fine, 0.9, runs, figures);
  ask("large", boulders, 10.0, runs, figures);
  std::printf("triangles: ramps %zu, large %zu; check sum %g\n", fine.size(), boulders.size(), sink);
  report("terrain", figures);
  return 0;
}

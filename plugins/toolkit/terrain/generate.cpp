// Boulders, stairs and a ditch on a grid.
#include "terrain/generate.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

namespace foothold::terrain {
namespace {

double to_grid(double length) { return std::round(length * 1e4) / 1e4; }

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : random_(seed) {}
  double length(double low, double high) { return low + (high - low) * static_cast<double>(random_() >> 11) * 0x1.0p-53; }

 private:
  std::mt19937_64 random_;
};

// Square fields of a height field, halved along alternate diagonals. height(x, y) is asked at the grid's points, in m.
struct Grid {
  explicit Grid(const Options& options)
      : fields(static_cast<int>(std::ceil(options.size / options.grid - 1e-9))),
        edge(options.size / fields),
        half(0.5 * options.size) {}

  template <class Height>
  mesh::TriangleMesh mesh(Height&& height) const {
    std::vector<Vector3d> vertices;
    std::vector<std::array<int, 3>> triangles;
    for (int j = 0; j <= fields; ++j)
      for (int i = 0; i <= fields; ++i) {
        const double x = to_grid(edge * i - half), y = to_grid(edge * j - half);
        vertices.emplace_back(x, y, to_grid(height(x, y)));
      }
    for (int j = 0; j < fields; ++j)
      for (int i = 0; i < fields; ++i) {
        const int a = j * (fields + 1) + i, b = a + 1, d = a + fields + 1, c = d + 1;
        if ((i + j) % 2 == 0) {
          triangles.push_back({a, b, c});
          triangles.push_back({a, c, d});
        } else {
          triangles.push_back({a, b, d});
          triangles.push_back({b, c, d});
        }
      }
    return mesh::joined(vertices, triangles);
  }

  int fields;
  double edge, half;  // m
};

// 0 at the rim (1 and beyond), 1 in the middle; level at both.
double bump(double share) {
  const double t = std::clamp(1.0 - share, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

// Low waves of the ground: values at the points of a coarse lattice, joined smoothly.
class Waves {
 public:
  Waves(Draw& draw, double size, double spacing, double height)
      : count_(static_cast<int>(size / spacing) + 3), spacing_(spacing), low_(-0.5 * size - spacing) {
    for (int k = 0; k < count_ * count_; ++k) heights_.push_back(draw.length(-height, height));
  }
  double operator()(double x, double y) const {
    const double u = (x - low_) / spacing_, v = (y - low_) / spacing_;
    const int i = std::clamp(static_cast<int>(u), 0, count_ - 2), j = std::clamp(static_cast<int>(v), 0, count_ - 2);
    const double a = bump(1.0 - (u - i)), b = bump(1.0 - (v - j));
    return (at(i, j) * (1.0 - a) + at(i + 1, j) * a) * (1.0 - b) + (at(i, j + 1) * (1.0 - a) + at(i + 1, j + 1) * a) * b;
  }

 private:
  double at(int i, int j) const { return heights_[static_cast<std::size_t>(j * count_ + i)]; }
  int count_;
  double spacing_, low_;
  std::vector<double> heights_;
};

mesh::TriangleMesh boulders(const Options& options) {
  Draw draw(options.seed);
  const Waves waves(draw, options.size, 0.8, 0.03);
  struct Rock {
    double x, y, radius, height;
  };
  std::vector<Rock> rocks;
  const auto count = static_cast<std::size_t>(1.2 * options.size * options.size);
  for (std::size_t k = 0; k < count; ++k) {
    Rock rock{};
    rock.x = draw.length(-0.5 * options.size, 0.5 * options.size);
    rock.y = draw.length(-0.5 * options.size, 0.5 * options.size);
    rock.radius = draw.length(0.2, 0.6);
    rock.height = rock.radius * draw.length(0.2, 0.7);
    rocks.push_back(rock);
  }
  const double reach = 0.6;
  // Rocks by squares as wide as the greatest of them, so that many cost no more each than few.
  const int squares = static_cast<int>(options.size / reach) + 3;
  const auto square = [&](double at) {
    return std::clamp(static_cast<int>((at + 0.5 * options.size) / reach) + 1, 1, squares - 2);
  };
  std::vector<std::vector<Rock>> near(static_cast<std::size_t>(squares) * static_cast<std::size_t>(squares));
  const auto cell = [&](int i, int j) -> std::vector<Rock>& { return near[static_cast<std::size_t>(j * squares + i)]; };
  for (const Rock& rock : rocks) cell(square(rock.x), square(rock.y)).push_back(rock);
  return Grid(options).mesh([&](double x, double y) {
    double z = 0.0;
    for (int j = square(y) - 1; j <= square(y) + 1; ++j)
      for (int i = square(x) - 1; i <= square(x) + 1; ++i)
        for (const Rock& rock : cell(i, j)) {
          const double off = std::sqrt((x - rock.x) * (x - rock.x) + (y - rock.y) * (y - rock.y));
          z = std::max(z, rock.height * bump(off / rock.radius));
        }
    return z + waves(x, y);
  });
}

mesh::TriangleMesh stairs(const Options& options) {
  Draw draw(options.seed);
  const double half = 0.5 * options.size, landing = 0.25 * options.size;
  std::vector<double> x{-half}, z;  // of the treads' front edges and heights
  double at = to_grid(-half + landing), height = 0.0;
  while (at < half - landing) {
    x.push_back(at);
    z.push_back(height);
    at = to_grid(at + draw.length(0.28, 0.40));
    height = to_grid(height + draw.length(0.05, 0.12));
  }
  x.push_back(half);
  z.push_back(height);
  std::vector<Vector3d> vertices;
  std::vector<std::array<int, 3>> triangles;
  const auto quad = [&](const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& d) {
    const int first = static_cast<int>(vertices.size());
    for (const Vector3d& v : {a, b, c, d}) vertices.push_back(v);
    triangles.push_back({first, first + 1, first + 2});
    triangles.push_back({first, first + 2, first + 3});
  };
  for (std::size_t k = 0; k < z.size(); ++k) {
    const double from = x[k], to = x[k + 1];
    quad({from, -half, z[k]}, {to, -half, z[k]}, {to, half, z[k]}, {from, half, z[k]});
    if (k + 1 < z.size()) quad({to, -half, z[k]}, {to, -half, z[k + 1]}, {to, half, z[k + 1]}, {to, half, z[k]});
  }
  return mesh::joined(vertices, triangles);
}

mesh::TriangleMesh ditch(const Options& options) {
  Draw draw(options.seed);
  const Waves waves(draw, options.size, 0.8, 0.02);
  const double width = draw.length(0.7, 0.9), depth = draw.length(0.5, 0.6), slope = 0.25;
  // The crossing is where the bottom rises to `shallow`, which the banks reach at a gentle slope.
  const double crossing = draw.length(-0.25, 0.25) * options.size, shallow = 0.08;
  return Grid(options).mesh([&](double x, double y) {
    const double off = std::max(0.0, std::abs(y - crossing) - 0.4);
    const double deep = std::min(depth, shallow + slope * 2.0 * off);
    return waves(x, y) - deep * bump(std::abs(x) / width);
  });
}

}  // namespace

std::optional<Family> family_named(std::string_view name) {
  if (name == "ramps") return Family::kRamps;
  if (name == "boulders") return Family::kBoulders;
  if (name == "stairs") return Family::kStairs;
  if (name == "ditch") return Family::kDitch;
  return std::nullopt;
}

Terrain generate(Family family, const Options& options) {
  if (family == Family::kRamps) return ramps();
  if (!(options.size >= 1.0 && options.size <= 100.0)) throw std::invalid_argument("a terrain's size is 1 to 100 m");
  if (!(options.grid >= 0.01 && options.grid <= 1.0)) throw std::invalid_argument("a terrain's grid is 0.01 to 1 m");
  if (options.size / options.grid > 700.0) throw std::invalid_argument("a terrain has 700 fields along a side at most");
  const char* name = family == Family::kBoulders ? "boulders" : family == Family::kStairs ? "stairs" : "ditch";
  mesh::TriangleMesh mesh = family == Family::kBoulders ? boulders(options)
                            : family == Family::kStairs ? stairs(options)
                                                        : ditch(options);
  return make_terrain(std::move(mesh), std::string(name) + ", seed " + std::to_string(options.seed));
}

}  // namespace foothold::terrain

#include "contact/simplex.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace foothold::contact::simplex {

namespace {

#define FOOTHOLD_INLINE inline __attribute__((always_inline))

constexpr std::array<double, 6> kPerturbed = {1.3e-7, 0.7e-7, 1.0 + 1.1e-7, 0.9e-7, 1.7e-7, 0.5e-7};
constexpr double kZero = 1e-12;          // of an x
constexpr double kLeastPivot = 1e-9;     // of a step's change of a basic x
constexpr double kSeparation = 2.5e-10;  // least y.w of a separating wrench of unit size
constexpr double kOverhang = 0.5e-5;     // greatest y.g of one, as a part of y.w
// Columns of a circular cone come from one wider by this part of mu, which certificates forgive: then a column near to the best one
// is as good as the best one is for the cone as it is, and the method ends instead of making columns ever closer to each other.
constexpr double kWidening = 2e-10;
constexpr double kRoundoff = 1e-14;  // of a price, as a part of |y|
constexpr int kPivotsWithPerturbation = 200, kPivotsWithout = 200;

bool artificial(const Column& column) { return column.contact < 0; }

FOOTHOLD_INLINE double at(const std::array<Lanes, 3>& v, std::size_t axis, std::size_t lane) { return v[axis][lane]; }

// The wrench of a column, by rows.
FOOTHOLD_INLINE void wrench_of(const Problem& p, const Column& column, std::array<double, 6>& g) {
  if (column.contact < 0) {
    g.fill(0.0);
    g[static_cast<std::size_t>(-1 - column.contact)] = 1.0;
    return;
  }
  const Group& group = p.groups[static_cast<std::size_t>(column.contact / kLanes)];
  const auto lane = static_cast<std::size_t>(column.contact % kLanes);
  const double c = p.mu * column.cos, s = p.mu * column.sin;
  for (std::size_t k = 0; k < 3; ++k) g[k] = at(group.n, k, lane) + c * at(group.t, k, lane) + s * at(group.b, k, lane);
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t l = (k + 1) % 3, m = (k + 2) % 3;
    g[3 + k] = at(group.r, l, lane) * g[m] - at(group.r, m, lane) * g[l];
  }
}

// B^-1 g.
FOOTHOLD_INLINE void change_of_basics(const Basis& basis, const std::array<double, 6>& g, Lanes& d) {
  d = basis.inverse[0] * g[0];
  for (std::size_t k = 1; k < 6; ++k) d += basis.inverse[k] * g[k];
}

// `column`, whose B^-1 g is d, takes the place of the basis' column `row`.
FOOTHOLD_INLINE void pivot(Basis& basis, std::size_t row, const Column& column, const Lanes& d) {
  Lanes scaled = d * (1.0 / d[row]);
  scaled[row] = 0.0;
  const double own = 1.0 / d[row];
  const auto update = [&](Lanes & v) __attribute__((always_inline)) {
    const double share = v[row];
    v -= scaled * share;
    v[row] = share * own;
  };
  for (Lanes& v : basis.inverse) update(v);
  update(basis.x);
  basis.columns[row] = column;
}

FOOTHOLD_INLINE void clear(Basis& basis) {
  for (std::size_t k = 0; k < 6; ++k) {
    basis.inverse[k] = Lanes{};
    basis.inverse[k][k] = 1.0;
    basis.x[k] = kPerturbed[k];
    basis.columns[k] = {-1 - static_cast<int>(k), 0.0, 0.0};
  }
  basis.x[6] = basis.x[7] = 0.0;
}

FOOTHOLD_INLINE void rebuild_here(Problem& p) {
  const std::array<Column, 6> wanted = p.basis.columns;
  clear(p.basis);
  for (const Column& column : wanted) {
    if (artificial(column)) continue;
    std::array<double, 6> g;
    Lanes d;
    wrench_of(p, column, g);
    change_of_basics(p.basis, g, d);
    std::size_t row = 6;
    double most = 1e-7;
    for (std::size_t i = 0; i < 6; ++i) {
      if (!artificial(p.basis.columns[i]) || !(std::abs(d[i]) > most)) continue;
      most = std::abs(d[i]);
      row = i;
    }
    if (row < 6) pivot(p.basis, row, column, d);
  }
}

// c of each row, and whether all are 0: no infeasibility.
FOOTHOLD_INLINE bool costs(const Basis& basis, const Lanes& x, std::array<double, 6>& c) {
  bool none = true;
  for (std::size_t i = 0; i < 6; ++i) {
    c[i] = x[i] < -kZero ? -1.0 : (artificial(basis.columns[i]) && x[i] > kZero ? 1.0 : 0.0);
    none = none && c[i] == 0.0;
  }
  return none;
}

struct Best {
  double price = 0.0;  // of the column
  double reach = 0.0;  // the greatest y.g over the cones as they are
  Column column;
};

// The column of the greatest y.g.
template <bool kCircular>
FOOTHOLD_INLINE Best price(const Problem& p, const std::array<double, 6>& y) {
  const double mu = p.mu;
  double most = -std::numeric_limits<double>::infinity();
  int contact = -1;
  double best_a = 0.0, best_b = 0.0;
  for (std::size_t q = 0; q < p.groups.size(); ++q) {
    const Group& group = p.groups[q];
    const std::array<Lanes, 3>& r = group.r;
    const Lanes vx = y[0] + (y[4] * r[2] - y[5] * r[1]);
    const Lanes vy = y[1] + (y[5] * r[0] - y[3] * r[2]);
    const Lanes vz = y[2] + (y[3] * r[1] - y[4] * r[0]);
    const Lanes n = vx * group.n[0] + vy * group.n[1] + vz * group.n[2];
    const Lanes a = vx * group.t[0] + vy * group.t[1] + vz * group.t[2];
    const Lanes b = vx * group.b[0] + vy * group.b[1] + vz * group.b[2];
    Lanes along;
    if constexpr (kCircular) {
      const Lanes squared = a * a + b * b;
      for (std::size_t i = 0; i < kLanes; ++i) along[i] = std::sqrt(squared[i]);
    } else {
      along = a;
      for (std::size_t j = 1; j < p.cos.size(); ++j) {
        const Lanes other = p.cos[j] * a + p.sin[j] * b;
        along = other > along ? other : along;
      }
    }
    const Lanes total = n + mu * along;
    const int here = std::min(kLanes, p.contacts - static_cast<int>(q) * kLanes);
    for (int i = 0; i < here; ++i) {
      const auto lane = static_cast<std::size_t>(i);
      if (!(total[lane] > most)) continue;
      most = total[lane];
      contact = static_cast<int>(q) * kLanes + i;
      best_a = a[lane];
      best_b = b[lane];
    }
  }
  Best out{most, most, {contact, 1.0, 0.0}};
  if constexpr (kCircular) {
    const double length = std::sqrt(best_a * best_a + best_b * best_b);
    if (length > 0.0) out.column = {contact, (1.0 + kWidening) * best_a / length, (1.0 + kWidening) * best_b / length};
    out.price += kWidening * mu * length;
  } else {
    double longest = -std::numeric_limits<double>::infinity();
    for (std::size_t j = 0; j < p.cos.size(); ++j) {
      const double along = p.cos[j] * best_a + p.sin[j] * best_b;
      if (!(along > longest)) continue;
      longest = along;
      out.column.cos = p.cos[j];
      out.column.sin = p.sin[j];
    }
  }
  return out;
}

// The row that leaves when the entering column grows from 0 until the sum of infeasibilities, which falls by `price` at first, no
// longer falls: each basic x that meets its bound takes away from the slope. 6 if no row ever stops it.
FOOTHOLD_INLINE std::size_t leaving_row(const Basis& basis, const Lanes& x, const Lanes& d, double price) {
  std::array<double, 6> step, bend;
  for (std::size_t i = 0; i < 6; ++i) {
    const bool art = artificial(basis.columns[i]);
    const double size = std::abs(d[i]);
    step[i] = std::numeric_limits<double>::infinity();
    bend[i] = 0.0;
    if (!(size > kLeastPivot)) continue;
    if (art && std::abs(x[i]) <= kZero) {
      step[i] = 0.0;
      bend[i] = size;
    } else if (x[i] < -kZero ? d[i] < 0.0 : d[i] > 0.0) {
      step[i] = std::max(x[i] / d[i], 0.0);
      bend[i] = art ? 2.0 * size : size;
    }
  }
  double slope = -price;
  for (;;) {
    std::size_t next = 6;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 6; ++i) {
      if (step[i] < nearest || (step[i] == nearest && next < 6 && bend[i] > bend[next])) {
        nearest = step[i];
        next = i;
      }
    }
    if (next == 6) return 6;
    slope += bend[next];
    if (slope >= 0.0) return next;
    step[next] = std::numeric_limits<double>::infinity();
  }
}

template <bool kCircular>
FOOTHOLD_INLINE Outcome run(Problem& p, Lanes& x, int limit) {
  Basis& basis = p.basis;
  for (int round = 0; round < limit; ++round) {
    std::array<double, 6> c;
    if (costs(basis, basis.inverse[2], c)) return Outcome::kBalanced;
    if (&x != &basis.inverse[2] && costs(basis, x, c)) return Outcome::kStuck;
    double size = 0.0;
    for (std::size_t k = 0; k < 6; ++k) {
      p.y[k] = 0.0;
      for (std::size_t i = 0; i < 6; ++i) p.y[k] += c[i] * basis.inverse[k][i];
      size += std::abs(p.y[k]);
    }
    if (!std::isfinite(size)) return Outcome::kStuck;
    const Best best = price<kCircular>(p, p.y);
    if (p.y[2] > kSeparation * size && !(best.reach > kOverhang * p.y[2])) return Outcome::kSeparated;
    if (!(best.price > kRoundoff * size)) return Outcome::kStuck;
    std::array<double, 6> g;
    Lanes d;
    wrench_of(p, best.column, g);
    change_of_basics(basis, g, d);
    const std::size_t row = leaving_row(basis, x, d, best.price);
    if (row == 6) return Outcome::kStuck;
    pivot(basis, row, best.column, d);
    ++p.pivots;
  }
  return Outcome::kStuck;
}

// The perturbed problem first: the true one is degenerate, as five of the six numbers of w are 0. Its last basis is near the
// true one's best.
template <bool kCircular>
FOOTHOLD_INLINE Outcome solve_here(Problem& p) {
  const Outcome outcome = run<kCircular>(p, p.basis.x, kPivotsWithPerturbation);
  if (outcome != Outcome::kStuck) return outcome;
  return run<kCircular>(p, p.basis.inverse[2], kPivotsWithout);
}

// One body for every machine, compiled three times; without contraction each gives the same bytes.
FOOTHOLD_INLINE Outcome solve_either(Problem& p) { return p.edges == 0 ? solve_here<true>(p) : solve_here<false>(p); }

Outcome solve_plain(Problem& p) { return solve_either(p); }
[[gnu::target("avx2")]] Outcome solve_avx2(Problem& p) { return solve_either(p); }
[[gnu::target("avx512f,avx512vl,avx512dq")]] Outcome solve_avx512(Problem& p) { return solve_either(p); }

void rebuild_plain(Problem& p) { rebuild_here(p); }
[[gnu::target("avx2")]] void rebuild_avx2(Problem& p) { rebuild_here(p); }
[[gnu::target("avx512f,avx512vl,avx512dq")]] void rebuild_avx512(Problem& p) { rebuild_here(p); }

struct Kernel {
  Outcome (*solve)(Problem&) = solve_plain;
  void (*rebuild)(Problem&) = rebuild_plain;
};

Kernel best_kernel() {
  __builtin_cpu_init();
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq"))
    return {solve_avx512, rebuild_avx512};
  if (__builtin_cpu_supports("avx2")) return {solve_avx2, rebuild_avx2};
  return {};
}

const Kernel kKernel = best_kernel();

}  // namespace

void start_from_nothing(Problem& problem) { clear(problem.basis); }
void rebuild(Problem& problem) { kKernel.rebuild(problem); }
Outcome solve(Problem& problem) { return kKernel.solve(problem); }

}  // namespace foothold::contact::simplex

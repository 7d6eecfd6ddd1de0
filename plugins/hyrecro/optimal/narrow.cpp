#include "hyrecro/optimal/narrow.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <queue>

namespace foothold::hyrecro {
namespace {

// Cells are not cut any finer.
struct Fineness {
  double turn = 0.0, across = 0.0;  // rad, m
  int cells = 0;                    // at most
};
constexpr double kSame = 1e-5;  // m: what is proved holds for ends that lie apart by so much more or less
constexpr int kLook = 4;        // after so many cells the middle of one is looked at alone
constexpr Fineness kOne{0.004, 0.001, 300}, kTwo{0.001, 0.0004, 1500};

// Footholds of a strip, wherever along it they are: a stretch across and a range of headings, modulo pi (a sole that faces about
// reaches the same).
struct Cell {
  double low = 0.0, high = 0.0;      // m, of strip.across()
  double heading = 0.0, turn = 0.0;  // rad, seen from the strip's direction; half the range
  double bound = 0.0;                // m
  // m, no more than in the cell that this one was cut from: advances to its footholds from either end.
  double first = std::numeric_limits<double>::infinity(), second = std::numeric_limits<double>::infinity();
  friend bool operator<(const Cell& a, const Cell& b) { return a.bound < b.bound; }
};

// The least half width of the plate across the strip, of all headings of the cell.
double half_width(const Vector2d& plate, const Cell& cell) {
  const auto at = [&](double heading) {
    return 0.5 * (plate.x() * std::fabs(std::sin(heading)) + plate.y() * std::fabs(std::cos(heading)));
  };
  // Between multiples of a right angle it is concave.
  double least = std::min(at(cell.heading - cell.turn), at(cell.heading + cell.turn));
  const double quarter = 0.5 * std::numbers::pi;
  for (double k = std::ceil((cell.heading - cell.turn) / quarter); k * quarter <= cell.heading + cell.turn; k += 1.0)
    least = std::min(least, at(k * quarter));
  return least;
}

// Best first; `bound_of` tells of a cell, whose stretch is cut to where the plate fits. The greatest bound that is left when cells
// are fine; `needed` or less: no foothold has more than that. What is more than `enough` need not be exact.
template <typename Bound>
double greatest(const Strip& strip, const Vector2d& plate, const Fineness& fine, double needed, double enough,
                const Bound& bound_of) {
  std::priority_queue<Cell> open;
  const auto add = [&](Cell cell) {
    const double half = half_width(plate, cell);
    cell.low = std::max(cell.low, strip.low - strip.inset + half);
    cell.high = std::min(cell.high, strip.high + strip.inset - half);
    if (cell.low > cell.high + 1e-9) return;
    cell.bound = bound_of(cell);
    if (cell.bound > needed) open.push(cell);
  };
  constexpr int kTurns = 8;
  for (int i = 0; i < kTurns; ++i)
    add({strip.low - strip.inset, strip.high + strip.inset, std::numbers::pi * i / kTurns, 0.5 * std::numbers::pi / kTurns});
  for (int cells = 0; !open.empty(); ++cells) {
    const Cell top = open.top();
    const bool turn = top.turn > fine.turn, across = top.high - top.low > fine.across;
    if ((!turn && !across) || cells == fine.cells) return top.bound;
    if (cells % kLook == 0) {
      Cell middle = top;
      middle.low = middle.high = 0.5 * (top.low + top.high);
      middle.turn = 0.0;
      if (half_width(plate, middle) <= strip.inset + std::min(middle.low - strip.low, strip.high - middle.low) &&
          (middle.bound = bound_of(middle)) > enough)
        return middle.bound;
    }
    open.pop();
    Cell one = top, two = top;
    // A turn by so much moves a foot about as far as half of the stretch does.
    if (turn && (!across || 0.2 * top.turn > 0.5 * (top.high - top.low))) {
      one.turn = two.turn = 0.5 * top.turn;
      one.heading -= one.turn;
      two.heading += two.turn;
    } else {
      one.high = two.low = 0.5 * (top.low + top.high);
    }
    add(one);
    add(two);
  }
  return needed;
}

// From `from` into the cell; `sense` as in furthest().
double advance_into(const StrideBounds& bounds, const Strip& strip, const Foothold& from, double sense, const Cell& cell,
                    double enough) {
  const Vector2d heading = direction(from.heading), other = direction(cell.heading);
  const Vector2d seen(sense * strip.along.dot(heading), sense * strip.across(heading));
  const double at = strip.across(from.at), low = sense * (cell.low - at), high = sense * (cell.high - at);
  return bounds.advance(seen, std::min(low, high), std::max(low, high), sense * other, cell.turn, enough);
}

}  // namespace

double furthest(const StrideBounds& bounds, const Strip& strip, const Vector2d& plate, const Foothold& from, double sense) {
  return greatest(strip, plate, kOne, 0.0, std::numeric_limits<double>::infinity(),
                  [&](const Cell& cell) { return advance_into(bounds, strip, from, sense, cell, 0.0); });
}

bool two_may_do(const StrideBounds& bounds, const Strip& strip, const Vector2d& plate, const Foothold& u, const Foothold& v) {
  const double way = strip.along.dot(v.at - u.at), sense = way < 0.0 ? -1.0 : 1.0, needed = std::fabs(way) - kSame;
  return greatest(strip, plate, kTwo, needed, needed, [&](Cell& cell) {
           const double most = std::min(cell.second, bounds.reach());
           cell.first = std::min(cell.first, advance_into(bounds, strip, u, sense, cell, needed - most));
           if (cell.first + most <= needed) return needed;
           cell.second = std::min(most, advance_into(bounds, strip, v, -sense, cell, needed - cell.first));
           return cell.first + cell.second;
         }) > needed;
}

}  // namespace foothold::hyrecro

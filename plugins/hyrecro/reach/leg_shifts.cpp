#include "hyrecro/reach/leg_shifts.hpp"

#include <array>

namespace foothold::hyrecro {
namespace {

constexpr int kAngles = 192;        // cells of a mechanism's angle, from 0 to its greatest
constexpr int kSamples = 8;         // of the mechanism in each
constexpr double kRounding = 1e-6;  // m and rad

// Least and greatest offsets of a mechanism by its angle's size, rounded outwards; beyond the greatest angle none.
class Offsets {
 public:
  explicit Offsets(const kinematics::PlanarMechanism& mechanism) : most_(mechanism.greatest_phi()), step_(most_ / kAngles) {
    for (int i = 0; i < kAngles; ++i) {
      double low = 1e9, high = -1e9, change = 0.0;
      kinematics::Interval before;
      for (int k = 0; k <= kSamples; ++k) {
        const kinematics::Interval here = mechanism.offsets(step_ * (i + static_cast<double>(k) / kSamples));
        if (here.empty()) continue;
        if (!before.empty()) change = std::max({change, std::fabs(here.low - before.low), std::fabs(here.high - before.high)});
        low = std::min(low, here.low);
        high = std::max(high, here.high);
        before = here;
      }
      // Between two samples it does not go further than from one to the next.
      cells_[static_cast<std::size_t>(i)] = {low - change - kRounding, high + change + kRounding};
    }
  }
  double most() const { return most_; }
  // Of all angles between two.
  kinematics::Interval between(double from, double to) const {
    const double nearest = from > 0.0 ? from : to < 0.0 ? -to : 0.0, farthest = std::max(std::fabs(from), std::fabs(to));
    if (nearest > most_ + kRounding) return {};
    const int first = std::clamp(static_cast<int>((nearest - kRounding) / step_), 0, kAngles - 1);
    const int last = std::clamp(static_cast<int>((farthest + kRounding) / step_), 0, kAngles - 1);
    kinematics::Interval out{1e9, -1e9};
    for (int i = first; i <= last; ++i) {
      out.low = std::min(out.low, cells_[static_cast<std::size_t>(i)].low);
      out.high = std::max(out.high, cells_[static_cast<std::size_t>(i)].high);
    }
    return out;
  }

 private:
  double most_, step_;
  std::array<kinematics::Interval, kAngles> cells_;
};

struct Range {
  double low, high;
};
// Of the product of what is never negative with anything.
Range times(const Range& never_negative, const Range& any) {
  return {std::min(never_negative.low * any.low, never_negative.high * any.low),
          std::max(never_negative.low * any.high, never_negative.high * any.high)};
}

Range sines(double from, double to) { return {std::sin(from), std::sin(to)}; }  // within +-90 deg
Range cosines(double from, double to) {
  return {std::min(std::cos(from), std::cos(to)), from <= 0.0 && to >= 0.0 ? 1.0 : std::max(std::cos(from), std::cos(to))};
}

}  // namespace

LegShifts::LegShifts(const Model& model) {
  most_lean_ = 2.0 * model.mechanism.greatest_phi();
  lean_step_ = 2.0 * most_lean_ / kLeans;
  height_step_ =
      (model.ankle_height + 2.0 * model.mechanism.offsets(0.0).high - model.core + model.hip_drop + 2.0 * kRounding) / kHeights;
  fill(model);
  column_.push_back(square_.front());
  for (int level = 1; level < kLevels; ++level) {
    auto& square = square_.emplace_back(static_cast<std::size_t>(leans(level) * heights(level)));
    auto& column = column_.emplace_back(static_cast<std::size_t>(kLeans * heights(level)));
    for (int height = 0; height < heights(level); ++height) {
      for (int lean = 0; lean < leans(level); ++lean)
        for (int part = 0; part < 4; ++part)
          square[cell(level, lean, height)].join(at(level - 1, 2 * lean + part % 2, 2 * height + part / 2));
      for (int lean = 0; lean < kLeans; ++lean)
        for (int part = 0; part < 2; ++part) column[cell(level, lean, height)].join(of_lean(level - 1, lean, 2 * height + part));
    }
  }
}

// The finest cells. What leans by -psi is the mirror image of what leans by psi.
void LegShifts::fill(const Model& model) {
  const Offsets offsets(model.mechanism);
  auto& cells = square_.emplace_back(static_cast<std::size_t>(kLeans * kHeights));
  const double step = offsets.most() / kAngles;
  for (int lean = kLeans / 2; lean < kLeans; ++lean) {
    const double low = -most_lean_ + lean * lean_step_, high = low + lean_step_;
    Range ankle_up{1e9, -1e9}, ankle_beside{1e9, -1e9};
    for (int k = 0; k <= 4; ++k) {
      const double psi = low + 0.25 * k * (high - low), y = model.ankle_height * std::cos(psi),
                   x = model.ankle_height * std::sin(psi);
      ankle_up = {std::min(ankle_up.low, y), std::max(ankle_up.high, y)};
      ankle_beside = {std::min(ankle_beside.low, x), std::max(ankle_beside.high, x)};
    }
    for (int angle = -kAngles; angle < kAngles; ++angle) {
      const double from = angle * step, to = from + step;
      const kinematics::Interval upper = offsets.between(from, to), ankle = offsets.between(low - to, high - from);
      if (upper.empty() || ankle.empty() || upper.low + ankle.low > upper.high + ankle.high) continue;
      const Range lambda{std::max(0.0, upper.low + ankle.low - model.core), upper.high + ankle.high - model.core};
      if (lambda.high < 0.0) continue;
      const Range up = times(lambda, cosines(from, to)), aside = times(lambda, sines(from, to));
      const Range tangents{std::tan(from), std::tan(to)};
      const double base_low = ankle_up.low + model.hip_drop - kRounding, base_high = ankle_up.high + model.hip_drop + kRounding;
      const int first = std::clamp(static_cast<int>((up.low + base_low) / height_step_), 0, kHeights - 1);
      const int last = std::clamp(static_cast<int>((up.high + base_high) / height_step_), 0, kHeights - 1);
      for (int height = first; height <= last; ++height) {
        // What of `up` leads into this cell.
        const Range part{std::max({up.low, height * height_step_ - base_high, 0.0}),
                         std::min(up.high, (height + 1) * height_step_ - base_low)};
        if (part.low > part.high) continue;
        Range s = times(part, tangents);
        s = {std::max(s.low, aside.low) + ankle_beside.low - kRounding,
             std::min(s.high, aside.high) + ankle_beside.high + kRounding};
        if (s.low > s.high) continue;
        cells[cell(0, lean, height)].join({static_cast<float>(s.low), static_cast<float>(s.high)});
        cells[cell(0, kLeans - 1 - lean, height)].join({static_cast<float>(-s.high), static_cast<float>(-s.low)});
      }
    }
  }
}

}  // namespace foothold::hyrecro

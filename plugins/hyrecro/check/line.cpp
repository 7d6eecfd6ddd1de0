#include "hyrecro/check/line.hpp"

#include "hyrecro/check/refusal.hpp"

namespace foothold::hyrecro {
namespace {

struct State {
  double part = 0.0;                               // of the piece
  double height = 0.0, aside = 0.0, turned = 0.0;  // m, m, and 2 sin of half the angle
};

class Way {
 public:
  Way(const Setting& setting, const Piece& piece, const Isometry3d& contact, Line line)
      : setting_(setting), piece_(piece), from_world_(contact.inverse()), line_(line) {}

  State at(double part) const {
    const Isometry3d sole =
        setting_.held * forward(setting_.model, from_joints(setting_.model, piece_.joints_at(part), setting_.holds));
    const Isometry3d is = from_world_ * sole;
    const double height = is.translation().z();
    return {part, height, std::max(is.translation().head<2>().norm(), -height),
            2.0 * std::sin(0.5 * hyrecro::turned(is, Isometry3d::Identity()))};
  }

  // Parts in the order of the way. Between two states nothing is farther off than at the farther one of them, but for the way's
  // bow. Returns whether the sole has reached its height.
  bool over(const State& from, const State& to) const {
    const double h = to.part - from.part, bow = piece_.rates.bend1 * h * h / 8.0, twist = piece_.rates.bend_turn1 * h * h / 8.0;
    const double tolerance = setting_.options.line_tolerance, proved = 1.5 * tolerance, lift = setting_.options.lift;
    if (std::min(from.height, to.height) - bow >= lift) return true;
    const bool kept = std::max(from.aside, to.aside) + bow <= proved && std::max(from.turned, to.turned) + twist <= proved;
    if (kept && std::max(from.height, to.height) + bow < lift) return false;
    if (std::max(bow, twist) > 0.25 * tolerance) {
      const State middle = at(0.5 * (from.part + to.part));
      return over(from, middle) || over(middle, to);
    }
    // As good as straight: the sole reaches its height where the line between the two does.
    if (from.height >= lift) return true;
    demand_kept(from);
    const bool reaches = to.height >= lift;
    demand_kept(reaches ? at(from.part + h * (lift - from.height) / (to.height - from.height)) : to);
    return reaches;
  }

 private:
  void demand_kept(const State& is) const {
    const double tolerance = setting_.options.line_tolerance;
    if (is.aside > tolerance || is.turned > tolerance)
      refuse("at ", piece_.time_at(is.part), " s of the motion: the free sole is ", is.aside, " m and ", is.turned,
             " rad off the normal of the face that it ", line_ == Line::kLeaves ? "leaves" : "meets", ", ", is.height,
             " m above it; ", tolerance, " are allowed up to ", setting_.options.lift, " m");
  }

  const Setting& setting_;
  const Piece& piece_;
  Isometry3d from_world_;
  Line line_;
};

}  // namespace

void judge_line(const Setting& setting, const std::vector<Piece>& pieces, const Isometry3d& contact, Line line) {
  const bool leaves = line == Line::kLeaves;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const Way way(setting, leaves ? pieces[k] : pieces[pieces.size() - 1 - k], contact, line);
    if (way.over(way.at(leaves ? 0.0 : 1.0), way.at(leaves ? 1.0 : 0.0))) return;
  }
}

}  // namespace foothold::hyrecro

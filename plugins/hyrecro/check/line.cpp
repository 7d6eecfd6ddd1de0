#include "hyrecro/check/line.hpp"

#include "hyrecro/check/refusal.hpp"

namespace foothold::hyrecro {
namespace {

class Way {
 public:
  Way(const Setting& setting, const Isometry3d& contact, Line line)
      : setting_(setting), from_world_(contact.inverse()), line_(line) {}

  // Parts of a piece in the order of the way. Returns whether the sole has reached its height.
  bool over(const Piece& piece, double from, double to) const {
    const double middle = 0.5 * (from + to), half = 0.5 * std::fabs(to - from);
    const State is = at(piece, middle);
    const double move = half * piece.rates.plate1, turn = half * piece.rates.turn1;
    const double tolerance = setting_.options.line_tolerance, proved = 1.5 * tolerance, lift = setting_.options.lift;
    // All before is proved, and the sole is high all over this part.
    if (is.height - move >= lift) return true;
    if (is.aside + move <= proved && is.turned + turn <= proved) {
      if (is.height + move < lift) return false;
    }
    if (std::max(move, turn) > 0.25 * tolerance) return over(piece, from, middle) || over(piece, middle, to);
    if (is.height >= lift) return true;
    if (is.aside > tolerance || is.turned > tolerance)
      refuse("at ", piece.time_at(middle), " s of the motion: the free sole is ", is.aside, " m and ", is.turned,
             " rad off the normal of the face that it ", line_ == Line::kLeaves ? "leaves" : "meets", ", ", is.height,
             " m above it; ", tolerance, " are allowed up to ", lift, " m");
    return false;
  }

 private:
  struct State {
    double height = 0.0, aside = 0.0, turned = 0.0;
  };

  State at(const Piece& piece, double part) const {
    const Isometry3d sole =
        setting_.held * forward(setting_.model, from_joints(setting_.model, piece.joints_at(part), setting_.holds));
    const Isometry3d is = from_world_ * sole;
    const double height = is.translation().z();
    return {height, std::max(is.translation().head<2>().norm(), -height), hyrecro::turned(is, Isometry3d::Identity())};
  }

  const Setting& setting_;
  Isometry3d from_world_;
  Line line_;
};

}  // namespace

void judge_line(const Setting& setting, const std::vector<Piece>& pieces, const Isometry3d& contact, Line line) {
  const Way way(setting, contact, line);
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const bool leaves = line == Line::kLeaves;
    if (leaves ? way.over(pieces[k], 0.0, 1.0) : way.over(pieces[pieces.size() - 1 - k], 1.0, 0.0)) return;
  }
}

}  // namespace foothold::hyrecro

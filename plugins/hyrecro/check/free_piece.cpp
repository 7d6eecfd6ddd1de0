#include "hyrecro/check/free_piece.hpp"

#include <sstream>

#include "hyrecro/check/refusal.hpp"

namespace foothold::hyrecro {
namespace {

constexpr double kNarrowest = 1e-7;  // m: bodies that move less within a part are not resolved further

std::string at_time(double time) {
  std::ostringstream out;
  out << "at " << time << " s of the motion";
  return out.str();
}

// What each body may move within half a part, m, in the order of the bodies.
struct Moves {
  std::array<double, 2> leg, plate;
  double hip = 0.0;
  double most() const { return std::max({leg[0], leg[1], plate[1], hip}); }
};

Moves moves_of(const Rates& rates, double half) {
  return {{half * rates.leg0, half * rates.leg1}, {0.0, half * rates.plate1}, half * rates.hip};
}

// In the order of kPairs: how much nearer the two bodies may come.
std::array<double, kPairs> approaches(const Moves& m) {
  return {m.leg[0] + m.leg[1], m.leg[0] + m.plate[1], m.leg[1] + m.plate[0],
          m.plate[0] + m.hip,  m.plate[1] + m.hip,    m.plate[0] + m.plate[1]};
}

class Proof {
 public:
  Proof(const Setting& setting, const Piece& piece, Clearance& least)
      : setting_(setting),
        piece_(piece),
        least_(least),
        floor_(setting.options.clearance - std::min(kProof, 0.5 * setting.options.clearance)) {}

  void over(double from, double to) {
    const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
    const Coordinates coordinates = from_joints(setting_.model, piece_.joints_at(middle), setting_.holds);
    const Bodies bodies = thinner(bodies_at(setting_.model, coordinates, setting_.held), kTouch);
    const Moves moves = moves_of(piece_.rates, half);
    if (scene_free(bodies, moves) && free_of_each_other(bodies, moves)) return;
    judge_clear(setting_, coordinates, at_time(piece_.time_at(middle)), least_);
    if (!(moves.most() > kNarrowest))
      refuse(at_time(piece_.time_at(middle)), ": bodies come too near to prove that they do not meet");
    over(from, middle);
    over(middle, to);
  }

 private:
  // Looks as far as the nearest so far, so that the margin comes out on the way.
  template <class Body>
  bool far(const Body& body, double move) {
    const double distance = setting_.obstacles.distance(body, std::max(least_.scene, setting_.options.clearance + move));
    if (distance > setting_.options.clearance) least_.scene = std::min(least_.scene, distance);
    return distance > setting_.options.clearance && distance - move > floor_;
  }

  bool scene_free(const Bodies& bodies, const Moves& moves) {
    for (std::size_t j = 0; j < 2; ++j)
      if (!far(bodies.leg[j], moves.leg[j])) return false;
    if (!far(bodies.hip, moves.hip)) return false;
    // The plate that holds does not move and was judged with the posture after.
    const collision::Box plate = thinner(bodies, kProof).plate[1];
    return setting_.obstacles.distance(plate, moves.plate[1]) > moves.plate[1];
  }

  bool free_of_each_other(const Bodies& bodies, const Moves& moves) {
    const std::array<double, kPairs> approach = approaches(moves);
    for (std::size_t pair = 0; pair < kPairs; ++pair) {
      if (pair_nearer(bodies, pair, std::max(floor_ + approach[pair], setting_.options.clearance))) return false;
      if (pair_nearer(bodies, pair, least_.itself)) least_.itself = pair_distance(bodies, pair);
    }
    return true;
  }

  const Setting& setting_;
  const Piece& piece_;
  Clearance& least_;
  double floor_;  // m: what is proved between two middles
};

}  // namespace

void judge_free(const Setting& setting, const Piece& piece, Clearance& least) {
  for (const auto& [joints, time] : {std::pair{piece.from, piece.begin}, {piece.to, piece.end}})
    judge_clear(setting, from_joints(setting.model, joints, setting.holds), at_time(time), least);
  Proof(setting, piece, least).over(0.0, 1.0);
}

}  // namespace foothold::hyrecro

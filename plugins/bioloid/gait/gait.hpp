// Steps of a walk (paper, section II.D): shift the weight over one foot, lift the other, carry it, put it down, settle between
// both.
//
// A stride is seen from its supporting sole. Between strides the robot stands with its centre of mass midway between its soles. All
// pieces are certified without obstacles and kept: a walk repeats them. `departure` reversed in time is the arrival at the same
// place, so that the set of places that can be reached is one table for lifting and for putting down.
//
// Metres, radians, seconds. Used by one thread at a time.
#pragma once

#include <array>
#include <map>
#include <random>
#include <stop_token>

#include "bioloid/gait/keys.hpp"
#include "bioloid/gait/paper_way.hpp"
#include "bioloid/gait/phase.hpp"
#include "bioloid/gait/swing.hpp"

namespace foothold::bioloid {

struct GaitOptions {
  double height = 0.120;  // of the hips over the ankles
  double lift = 0.010;    // of the swing sole
  Pace pace;
  Demands demands;
  // m, beyond Demands::balance: on one foot the weight is so far inside the sole. It is shifted no farther than that asks for, and
  // goes forward while the other foot does: over the sole's centre the joints travel twice as far.
  double reserve = 0.004;
  SearchOptions search;
  // The lifted sole's way by the paper's methods instead of lines and search, and the weight over the sole's centre, as there.
  std::optional<PaperOptions> paper;
};

// From standing midway to standing on one foot with the other lifted: shift and lift.
struct Departure {
  Phase shift, lift;
  Free raised;  // the end, in the free joints
  Fault fault = Fault::kNone;
  bool sound() const { return fault == Fault::kNone; }
};

struct Stride {
  Side support = Side::kRight;
  PlanarPose from, to;  // of the swing sole, seen from the supporting one
  double lift = 0.0;
  std::vector<Phase> phases;  // shift, lift, carry (one or more), lower, settle
};

class Gait {
 public:
  Gait(const Model& model, const GaitOptions& options);

  // Where the robot stands between strides.
  std::optional<KeyPosture> midway(Side support, const PlanarPose& swing) const;
  const Departure& departure(Side support, const PlanarPose& swing, double lift);
  // The same with samples a few times as far apart, certified as well: to find out whether there is one.
  const Departure& rough_departure(Side support, const PlanarPose& swing, double lift);
  // The way of the lifted sole between two places: at once; else beside the supporting sole on the way; else by search. Empty if
  // none.
  const std::vector<Phase>& carry(Side support, const PlanarPose& from, const PlanarPose& to, double lift, std::mt19937_64& random,
                                  std::stop_token stop);
  // Always by way of beside the supporting sole, which is what `placeable` asks for. Empty if that fails.
  std::vector<Phase> carry_beside(Side support, const PlanarPose& from, const PlanarPose& to, double lift);
  // Whether a sole can be put down at a place, and the weight brought over it from there, whatever came before: both departures,
  // and the way to beside the supporting sole, at the lift.
  bool placeable(Side support, const PlanarPose& swing, double lift);
  // False if that was asked before and found to be none.
  bool may_be_placeable(Side support, const PlanarPose& swing, double lift) const;
  // The way of the lifted sole by the paper's method, found and certified by `judge` with the supporting sole at `sole` in the
  // world: round the judge's obstacles. Not kept. Empty if none. Precondition: GaitOptions::paper.
  std::vector<Phase> paper_carry(Judge& judge, Side support, const PlanarPose& sole, const PlanarPose& from, const PlanarPose& to,
                                 double lift, std::mt19937_64& random, std::stop_token stop);
  // With the pieces of `departure` before and after a way of the lifted sole. Empty if a piece fails.
  std::optional<Stride> stride(Side support, const PlanarPose& from, const PlanarPose& to, double lift, std::mt19937_64& random,
                               std::stop_token stop);
  std::optional<Stride> stride_with(Side support, const PlanarPose& from, const PlanarPose& to, double lift,
                                    const std::vector<Phase>& way);
  // From any standing posture with both soles in place to standing midway; empty if it cannot be certified.
  std::optional<Phase> rise(const Joints& from, Side support, const PlanarPose& swing);

  const GaitOptions& options() const { return options_; }
  Judge& judge() { return judge_; }
  const PaperFigures& paper_figures() const { return paper_figures_; }

 private:
  // Of the centre of mass, when this foot stands alone.
  Eigen::Vector2d weight_on_one(const PlanarPose& swing) const;
  using Place = std::array<double, 5>;  // side, x, y, heading, lift
  using Way = std::array<double, 8>;
  Departure make_departure(Side support, const PlanarPose& swing, double lift, const Pace& pace);
  Pace rough() const { return {options_.pace.share, 4.0 * options_.pace.period}; }
  std::vector<Phase> make_carry(Side support, const PlanarPose& from, const PlanarPose& to, double lift, std::mt19937_64& random,
                                std::stop_token stop);
  std::optional<Phase> carry_line(const Support& support, const Free& a, const Free& b, const Pace& pace);

  const Model& model_;
  GaitOptions options_;
  Judge judge_;
  PaperFigures paper_figures_;
  std::map<Place, Departure> departures_, rough_departures_;
  std::map<Place, bool> placeable_;
  std::map<Way, std::vector<Phase>> carries_;
};

// Rounded to 1e-9, so that places that came about in different ways are one.
PlanarPose rounded(const PlanarPose& pose);

}  // namespace foothold::bioloid

// Half a cycle of the gait, judged at every instant. One thread at a time for one Judge.
#pragma once

#include "hexpiderix/walk/instant.hpp"

namespace foothold::hexpiderix {

class HalfCycleJudge {
 public:
  HalfCycleJudge(const Model& model, const terrain::Surface& surface, const WalkOptions& options);

  // From one stand to the other: `swinging` legs lift, travel and come down while the rest holds and the thorax moves evenly. Empty
  // if something is wrong on the way; then `because` says what.
  std::optional<HalfCycle> operator()(const Stand& from, const Stand& to, Legs swinging, std::string& because);

  long judged() const { return judged_; }

 private:
  struct Flight {
    Vector3d from, to, up;
    double height;  // m, over the line between
    Vector3d at(double part) const;
  };
  Flight flight(const Footholds& from, const Footholds& to, std::size_t leg) const;

  const Model& model_;
  const terrain::Surface& surface_;
  const WalkOptions& options_;
  contact::Equilibrium equilibrium_;
  long judged_ = 0;
};

}  // namespace foothold::hexpiderix

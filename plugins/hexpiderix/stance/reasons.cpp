// What a posture lacks, in words.
#include <cmath>
#include <cstdio>

#include "hexpiderix/stance/stance.hpp"

namespace foothold::hexpiderix {
namespace {

std::string leg_name(std::size_t leg) { return "leg " + std::to_string(leg + 1); }

std::string millimetres(double metres) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f mm", 1e3 * metres);
  return text;
}

}  // namespace

std::string reason(const Evaluation& evaluation) {
  using Fault = Evaluation::Fault;
  const std::string leg = leg_name(evaluation.leg);
  const std::string apart = " are only " + millimetres(evaluation.figure) + " apart";
  const std::string ground = evaluation.figure < 0.0 ? " is " + millimetres(-evaluation.figure) + " deep in the ground"
                                                     : " is only " + millimetres(evaluation.figure) + " above the ground";
  switch (evaluation.fault) {
    case Fault::kNone:
      return "stands";
    case Fault::kReach:
      return leg + " does not reach its place within its joints' limits";
    case Fault::kLegOnGround:
      return leg + ground;
    case Fault::kThoraxOnGround:
      return "the thorax" + ground;
    case Fault::kLegOnLeg:
      return leg + " and " + leg_name(evaluation.other) + apart;
    case Fault::kSlides:
      return "needs more friction than there is";
    case Fault::kLegOnThorax:
      return leg + " and the thorax" + apart;
  }
  return {};
}

}  // namespace foothold::hexpiderix

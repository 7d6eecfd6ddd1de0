#include "hyrecro/check/closure.hpp"

#include <limits>
#include <numbers>

#include "hyrecro/check/refusal.hpp"

namespace foothold::hyrecro {
namespace {

constexpr std::size_t kActuators = 8;

}  // namespace

double judge_limits(const Model& model, std::span<const double> joints, const std::string& where) {
  if (joints.size() != kJoints) refuse(where, ": ", kJoints, " joints are needed, ", joints.size(), " are given");
  const double shortest = model.mechanism.shortest(), longest = model.mechanism.longest();
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < kJoints; ++k) {
    if (!std::isfinite(joints[k])) refuse(where, ": joint ", kJointList[k], " is not a finite number");
    if (k >= kActuators) continue;
    const double reach = std::min(joints[k] - shortest, longest - joints[k]);
    if (reach < -kSame)
      refuse(where, ": actuator ", kJointList[k], " is ", joints[k], " m long, it can be ", shortest, " to ", longest, " m");
    least = std::min(least, reach);
  }
  return least;
}

Posed posed(const Model& model, std::span<const double> joints, Foot holds, const Isometry3d& held) {
  Posed out;
  out.coordinates = from_joints(model, joints, holds);
  const Frames at = frames(model, out.coordinates);
  out.free_sole = held * at.sole[1];
  // The base's X points from A's hip axis to B's, whichever foot holds.
  out.base = held * at.hip;
  if (holds == Foot::kB) out.base.rotate(Eigen::AngleAxisd(std::numbers::pi, Vector3d::UnitZ()));
  return out;
}

void judge_base(const Posed& is, const Isometry3d& sent, const std::string& where) {
  if (error_between(is.base, sent) > kPoseTolerance)
    refuse(where, ": the base is sent ", apart(is.base, sent), " m and ", turned(is.base, sent),
           " rad away from where the joints put it");
}

double judge_contact(const Posed& is, const Contact& contact, const std::string& where) {
  const double error = error_between(is.free_sole, contact.frame);
  if (error > kPoseTolerance)
    refuse(where, ": the sole of foot ", contact.limb, " is sent ", apart(is.free_sole, contact.frame), " m and ",
           turned(is.free_sole, contact.frame), " rad away from where the joints put it");
  return error;
}

}  // namespace foothold::hyrecro

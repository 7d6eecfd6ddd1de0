#include "hyrecro/check/path.hpp"

#include <numbers>

#include "hyrecro/check/closure.hpp"
#include "hyrecro/check/free_piece.hpp"
#include "hyrecro/check/line.hpp"
#include "hyrecro/check/rates.hpp"
#include "hyrecro/check/refusal.hpp"

namespace foothold::hyrecro {
namespace {

constexpr std::size_t kActuators = 8;
constexpr double kSlack = 1e-9;                          // of speeds, relative
constexpr double kLongestTurn = 2.0 * std::numbers::pi;  // rad, of a hip between two points: bounds the judge's own work

// Hip joints have no stops: whole turns do not count.
double difference(std::span<const double> a, std::span<const double> b) {
  if (a.size() != b.size()) return HUGE_VAL;
  double most = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    const double is = k < kActuators ? a[k] - b[k] : std::remainder(a[k] - b[k], 2.0 * std::numbers::pi);
    most = std::max(most, std::isfinite(is) ? std::fabs(is) : HUGE_VAL);
  }
  return most;
}

void judge_speed(const Model& model, const MotionPoint& from, const MotionPoint& to, const std::string& where) {
  const double time = to.time - from.time;
  if (!(time > 0.0)) refuse(where, ": comes ", time, " s after the point before it, times must grow");
  for (std::size_t k = 0; k < kJoints; ++k) {
    const bool hip = k >= kActuators;
    if (hip && !(std::fabs(to.joints[k] - from.joints[k]) <= kLongestTurn))
      refuse(where, ": joint ", kJointList[k], " turns by ", to.joints[k] - from.joints[k], " rad from the point before, ",
             kLongestTurn, " are allowed between two points");
    const double speed = std::fabs(to.joints[k] - from.joints[k]) / time, most = hip ? model.hip_speed : model.actuator_speed;
    if (speed > most * (1.0 + kSlack) + kSlack)
      refuse(where, ": joint ", kJointList[k], " moves at ", speed, hip ? " rad/s, " : " m/s, ", most, " are allowed");
  }
}

}  // namespace

double judge_path(const Setting& setting, const Stances& stances, const Step& step, const Posture& before, Clearance& least) {
  const std::vector<MotionPoint>& points = step.motion;
  if (const double error = difference(points.front().joints, before.joints); error > kSame)
    refuse("the motion begins ", error, " (m or rad) away from the joints before the step");
  if (const double error = difference(points.back().joints, step.after.joints); error > kSame)
    refuse("the motion ends ", error, " (m or rad) away from the joints after the step");

  double reach = HUGE_VAL;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const std::string where = "motion point " + std::to_string(k);
    reach = std::min(reach, judge_limits(setting.model, points[k].joints, where));
    const Posed is = posed(setting.model, points[k].joints, setting.holds, setting.held);
    judge_base(is, points[k].base, where);
    if (k == 0 && stances.lifted != nullptr) judge_contact(is, *stances.lifted, "the motion's begin");
    if (k == 0 && !(points[k].time >= 0.0)) refuse(where, ": its time is ", points[k].time, " s");
    if (k > 0) judge_speed(setting.model, points[k - 1], points[k], where);
  }
  std::vector<Piece> pieces;
  for (std::size_t k = 0; k + 1 < points.size(); ++k)
    pieces.push_back({points[k].joints, points[k + 1].joints,
                      rates_between(setting.model, points[k].joints, points[k + 1].joints, setting.holds), points[k].time,
                      points[k + 1].time});
  for (const Piece& piece : pieces)
    if (!std::isfinite(piece.rates.plate1)) refuse("from ", piece.begin, " s of the motion on its speed has no bound");
  for (const Piece& piece : pieces) judge_free(setting, piece, least);
  if (setting.options.lift <= 0.0) return reach;
  if (stances.lifted != nullptr) judge_line(setting, pieces, stances.lifted->frame, Line::kLeaves);
  judge_line(setting, pieces, stances.placed->frame, Line::kMeets);
  return reach;
}

}  // namespace foothold::hyrecro

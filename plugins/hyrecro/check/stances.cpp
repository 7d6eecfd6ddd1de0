#include "hyrecro/check/stances.hpp"

#include "hyrecro/check/refusal.hpp"

namespace foothold::hyrecro {
namespace {

// Null if the limb does not hold.
const Contact* contact_of(const std::vector<Contact>& stance, Foot foot, const char* when) {
  const Contact* found = nullptr;
  for (const Contact& contact : stance) {
    if (contact.limb != name_of(Foot::kA) && contact.limb != name_of(Foot::kB))
      refuse("there is no foot '", contact.limb, "' (", when, ")");
    if (contact.limb != name_of(foot)) continue;
    if (found != nullptr) refuse("foot ", name_of(foot), " holds twice ", when);
    found = &contact;
  }
  return found;
}

}  // namespace

Stances judge_stances(const Step& step, const Posture& before) {
  if (step.placed.size() != 1) refuse("one foot is placed in a step, not ", step.placed.size());
  Stances out;
  out.placed = &step.placed.front();
  if (out.placed->limb != name_of(Foot::kA) && out.placed->limb != name_of(Foot::kB))
    refuse("there is no foot '", out.placed->limb, "'");
  out.holds = out.placed->limb == name_of(Foot::kA) ? Foot::kB : Foot::kA;
  const char* holder = name_of(out.holds);
  out.held = contact_of(before.stance, out.holds, "before");
  out.lifted = contact_of(before.stance, other(out.holds), "before");
  if (out.held == nullptr) refuse("foot ", out.placed->limb, " is placed, but foot ", holder, " did not hold before");

  const Contact* still = contact_of(step.after.stance, out.holds, "after");
  const Contact* stands = contact_of(step.after.stance, other(out.holds), "after");
  if (still == nullptr) refuse("foot ", holder, " shall hold, but does not hold after the step");
  if (stands == nullptr) refuse("foot ", out.placed->limb, " is placed, but does not hold after the step");
  if (const double error = error_between(still->frame, out.held->frame); error > kSame)
    refuse("foot ", holder, " holds, but moves by ", apart(still->frame, out.held->frame), " m and ",
           turned(still->frame, out.held->frame), " rad");
  if (still->face != out.held->face)
    refuse("foot ", holder, " holds on face '", out.held->face, "', but on '", still->face, "' after the step");
  if (const double error = error_between(stands->frame, out.placed->frame); error > kSame)
    refuse("foot ", out.placed->limb, " is placed ", apart(stands->frame, out.placed->frame), " m and ",
           turned(stands->frame, out.placed->frame), " rad away from where it holds after the step");
  if (stands->face != out.placed->face)
    refuse("foot ", out.placed->limb, " is placed on face '", out.placed->face, "', but holds on '", stands->face, "'");
  return out;
}

}  // namespace foothold::hyrecro

// Places on their convex hull, each before the judge of equilibrium.
#include "octopod/check/carrying.hpp"

#include <cmath>

#include "contact/balance.hpp"
#include "contact/support_polygon.hpp"

namespace foothold::octopod {
namespace {

constexpr std::size_t kCorners = 8;  // of the squares round both ends of a piece

}  // namespace

void Carrying::add(double begin, double end, const std::array<std::uint8_t, kLegs>& feet, const Feet& contacts,
                   const Vector3d& from, const Vector3d& to, double bulge) {
  if (places_.empty() || feet != feet_) {
    finish();
    feet_ = feet;
    begin_ = begin;
    contacts_.clear();
    for (std::size_t k = 0; k < kLegs; ++k)
      if (feet[k] != 0) contacts_.push_back(contacts[k]);
  }
  end_ = end;
  if (places_.size() + kCorners > contact::SupportPolygon::kMostContacts) thin_out();
  // A disc lies within the square whose corners are so far away.
  const double side = std::sqrt(2.0) * bulge;
  for (const Vector3d& at : {from, to})
    for (const auto& [x, y] : {std::pair{side, 0.0}, {-side, 0.0}, {0.0, side}, {0.0, -side}})
      places_.push_back(at + Vector3d(x, y, 0.0));
}

void Carrying::thin_out() {
  const contact::SupportPolygon hull = contact::support_polygon(places_);
  if (hull.count >= 3 && hull.count + kCorners <= contact::SupportPolygon::kMostContacts) {
    places_.assign(hull.begin(), hull.end());
  } else {
    judge();
    places_.clear();
  }
}

void Carrying::judge() {
  const contact::SupportPolygon hull = contact::support_polygon(places_);
  const std::vector<Vector3d> corners = hull.count >= 3 ? std::vector<Vector3d>(hull.begin(), hull.end()) : places_;
  for (const Vector3d& at : corners) {
    if (contact::balanced(contacts_, at, setting_->options.friction, setting_->cone())) continue;
    std::string names;
    for (std::size_t k = 0; k < kLegs; ++k)
      if (feet_[k] != 0) names += " " + limb(static_cast<int>(k));
    refuse("the motion between ", begin_, " and ", end_, " s: no equilibrium on", names.empty() ? " no feet" : names,
           " at friction ", setting_->options.friction);
  }
}

void Carrying::finish() {
  if (!places_.empty()) judge();
  places_.clear();
}

}  // namespace foothold::octopod

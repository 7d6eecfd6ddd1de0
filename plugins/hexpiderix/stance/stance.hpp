// A posture of Hex-piderix on known footholds, and how safe it is: joints, collisions, NESM, friction.
//
// Metres, radians, world frame with gravity along -Z. Values; any thread.
#pragma once

#include <limits>
#include <memory>
#include <string>

#include "contact/equilibrium.hpp"
#include "contact/support_polygon.hpp"
#include "hexpiderix/model/body.hpp"

namespace foothold::hexpiderix {

// The ground beneath a stance as far as legs and thorax can meet it: the plane through a point. Irregular ground: see walk/.
struct Plane {
  Vector3d point = Vector3d::Zero();
  Vector3d normal = Vector3d::UnitZ();
  double above(const Vector3d& p) const { return (p - point).dot(normal); }
};

// Axes with Z along `up` (unit) and X as near to `ahead` as that allows.
Eigen::Matrix3d axes_along(const Vector3d& up, const Vector3d& ahead);

// A plane that falls by `slope` (rad) towards `direction` (rad from +X, seen from above); slope 0 is level.
Plane tilted_plane(double slope, double direction);

// Which feet hold where. Only entries of `supports` count.
struct Footholds {
  Legs supports;
  std::array<Vector3d, kLegs> points{};
  std::array<Vector3d, kLegs> normals{};  // of the ground, unit, out of it
};

// The footholds of the robot standing on `plane` over `centre` (its projection) with `heading` (rad) of leg 1, joints as in
// standing_joints(); and the thorax' pose there.
Footholds standing_footholds(const Model& model, const Plane& plane, const Vector3d& centre, double heading, Legs supports);
Isometry3d standing_thorax(const Model& model, const Plane& plane, const Vector3d& centre, double heading);

// Why a posture is none, or the figures of one.
struct Evaluation {
  enum class Fault { kNone, kReach, kLegOnGround, kThoraxOnGround, kLegOnLeg, kLegOnThorax, kSlides };
  Fault fault = Fault::kReach;
  std::size_t leg = 0, other = 0;  // whose fault; `other` of kLegOnLeg
  double figure = 0.0;             // m, between the bodies; negative: how deep in the ground
  Coordinates at;
  Vector3d centre_of_mass = Vector3d::Zero();                // world
  double nesm = -std::numeric_limits<double>::infinity();    // m
  double margin = -std::numeric_limits<double>::infinity();  // m, projected
  bool valid() const { return fault == Fault::kNone; }
};
std::string reason(const Evaluation& evaluation);

// Of the feet of these legs.
contact::SupportPolygon polygon_of(const Footholds& footholds, Legs legs);

// What swing legs do in a posture: their feet hang `lift` (m) above their standing places.
struct Swing {
  double lift = 0.0;
  bool raise = false;  // as far as it takes to clear the ground, up to the joints' limits
};

// Places the thorax over its footholds: legs in closed form, then collisions of supporting and swinging legs with the ground, with
// each other and of the thorax with the ground (`clearance`, m), then the centre of mass, NESM and projected margin.
Evaluation evaluate(const Model& model, const Plane& ground, const Footholds& footholds, const Isometry3d& thorax,
                    const Swing& swing, double clearance);

// The same figures of a posture as it is: centre of mass, NESM and projected margin, without asking for collisions.
Evaluation stability_of(const Model& model, const Footholds& footholds, const Coordinates& at);

// Least friction coefficient at which the stance is in equilibrium (exact circular cone); infinity if there is none.
double friction_needed(const Footholds& footholds, const Vector3d& centre_of_mass);
// Is it in equilibrium with this much? `equilibrium` keeps what helps with the next question.
bool stands(contact::Equilibrium& equilibrium, const Footholds& footholds, const Vector3d& centre_of_mass, double friction);

}  // namespace foothold::hexpiderix

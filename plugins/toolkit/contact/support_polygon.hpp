// The support polygon of a stance: the convex hull of its contacts seen from above, and how far inside it the centre of mass lies.
//
// Metres, world frame, gravity along -Z. Values; any thread.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <span>

namespace foothold::contact {

// Contacts that bound the stance, counter-clockwise seen from above, as they lie in space. Up to 32 contacts are taken.
struct SupportPolygon {
  static constexpr std::size_t kMostContacts = 32;
  static constexpr std::size_t kMost = 2 * kMostContacts;  // room while the chain is made
  std::array<Eigen::Vector3d, kMost> corners;
  std::size_t count = 0;  // 3 or more if the hull has an area; 2 or less if the contacts stand in a line or a point

  const Eigen::Vector3d* begin() const { return corners.data(); }
  const Eigen::Vector3d* end() const { return corners.data() + count; }
};

// By Andrew's monotone chain over the horizontal projections. Throws std::invalid_argument for more than kMostContacts.
SupportPolygon support_polygon(std::span<const Eigen::Vector3d> contacts);

// Signed distance, m, from the projected centre of mass to the polygon's nearest edge: positive inside. Without an area: minus the
// distance to the line or point. Minus infinity without contacts.
double projected_margin(const SupportPolygon& polygon, const Eigen::Vector3d& centre_of_mass);

}  // namespace foothold::contact

// Random stances, and their generators written down. Seeded; the same on every machine as far as std::mt19937_64 and the few
// operations on its numbers are.
#pragma once

#include <random>
#include <vector>

#include "contact/contact.hpp"

namespace foothold::contact {

struct Stance {
  std::vector<Contact> contacts;
  Vector3d com = Vector3d::Zero();
  double mu = 0.0;
};

// 4 to 8 contacts within 0.6 x 0.5 x 0.3 m, no plane through them all, normals up to 70 degrees off the vertical, the centre of
// mass up to 0.15 m beside the middle of the contacts and 0.05 to 0.25 m above it; mu 0.1 to 0.8. About 60 % of them are stable.
Stance random_stance(std::mt19937_64& random);
Stance random_stance(std::mt19937_64& random, int contacts);

// The same stance a little later: the centre of mass and the contacts moved by up to `metres`, the normals by as many radians.
Stance neighbour(std::mt19937_64& random, const Stance& stance, double metres);

// Wrenches (f, (p - com) x f) of the pyramids' edges, one a column, in the order of contacts: what equilibrium is about.
Eigen::Matrix<double, 6, Eigen::Dynamic> generators(const Stance& stance, int edges);

}  // namespace foothold::contact

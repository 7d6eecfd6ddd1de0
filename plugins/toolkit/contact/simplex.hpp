// The simplex method beneath Equilibrium, for one stance scaled to unit weight and unit greatest distance. Private to this library.
//
// Minimises the sum of infeasibilities of B x = w over bases B of six columns (composite phase one): a column is a unit vector of a
// row ("artificial": infeasible unless its x is 0) or the wrench of a direction on a contact's cone (infeasible if its x < 0).
// y = c B^-1, with c_i = -1 for a negative x_i, +-1 for an artificial, is at the minimum a separating wrench; a minimum of 0 gives
// forces.
#pragma once

#include <array>
#include <vector>

#include "contact/contact.hpp"

namespace foothold::contact::simplex {

// Eight numbers at once: as wide as the machine has them; the same result on each machine, as nothing is contracted.
using Lanes = double __attribute__((vector_size(64)));
constexpr int kLanes = 8;

// Eight contacts: place, frame; zeros where there is none.
struct Group {
  std::array<Lanes, 3> r, n, t, b;
};

// A column: the wrench of f = n + mu (cos t + sin b) at `contact`; or, if that is negative, the unit vector of row -1 - contact.
struct Column {
  int contact = -1;
  double cos = 0.0, sin = 0.0;
};

// Row i of x and of the inverse belongs to the basis' column i. Lanes 6 and 7 stay zero.
struct Basis {
  std::array<Column, 6> columns;
  std::array<Lanes, 6> inverse;  // B^-1, by columns; the third one is the true x, since w is the third unit vector
  Lanes x;                       // B^-1 of the perturbed w
};

enum class Outcome { kBalanced, kSeparated, kStuck };

struct Problem {
  std::vector<Group> groups;
  int contacts = 0;
  double mu = 0.0;
  int edges = 0;
  std::vector<double> cos, sin;  // of the edges
  Basis basis;
  std::array<double, 6> y{};  // after kSeparated
  int pivots = 0;
};

// The artificial basis.
void start_from_nothing(Problem& problem);
// The inverse of the columns that the basis names, from scratch, for the present contacts. Columns that depend on others are
// replaced by artificial ones.
void rebuild(Problem& problem);
Outcome solve(Problem& problem);

}  // namespace foothold::contact::simplex

// The simplex method beneath Equilibrium, for one stance scaled to unit weight and about unit distances. Private to this library.
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

constexpr int kLanes = 8;

// Eight numbers in a row, as wide vectors want them.
struct alignas(64) Eight {
  double v[kLanes];
  double& operator[](std::size_t i) { return v[i]; }
  const double& operator[](std::size_t i) const { return v[i]; }
};

// Eight contacts: place from the centre of mass, frame; zeros where there is none.
struct Group {
  std::array<Eight, 3> r, n, t, b;
};

// A column: the wrench of f = n + mu (cos t + sin b) at `contact`; or, if that is negative, the unit vector of row -1 - contact.
struct Column {
  int contact = -1;
  double cos = 0.0, sin = 0.0;
};

// Row i of x and of the inverse belongs to the basis' column i. Numbers 6 and 7 stay zero.
struct Basis {
  std::array<Eight, 6> inverse;  // B^-1, by columns; the third one is the true x, since w is the third unit vector
  Eight x;                       // B^-1 of the perturbed w
  Eight artificial;              // 1 where the column is
  std::array<Column, 6> columns;
};

enum class Outcome { kBalanced, kSeparated, kStuck };

struct Problem {
  std::vector<Group> groups;
  double length = 1.0;  // m: the unit of length; a power of 2
  double mu = 0.0;
  int edges = 0;
  // Of the edges from 0 to 90 degrees (of an odd pyramid: to 180); the others are their mirror images.
  std::vector<double> cos, sin;
  Basis basis;
  std::array<double, 6> y{};  // after kSeparated
  int pivots = 0;
};

// The loops, compiled for one kind of machine. All give the same bytes, as no multiplication is contracted with an addition.
struct Kernel {
  // Frames and places of the contacts, in units of problem.length. False, and nothing of use, if anything is not finite or a
  // normal not of unit length within 1e-6. Precondition: groups for all contacts.
  bool (*fill)(Problem& problem, std::span<const Contact> contacts, const Vector3d& com);
  // A first basis: the columns that reach farthest in six directions round w.
  void (*start)(Problem& problem);
  // The inverse of the columns that the basis names, from scratch, for the present contacts. Columns that depend on others are
  // replaced by artificial ones.
  void (*rebuild)(Problem& problem);
  // The same, sooner, for contacts near to those for which the basis was made; as rebuild() where that would be inexact.
  void (*renew)(Problem& problem);
  Outcome (*solve)(Problem& problem);
  // Forces of the basis, one a contact; returns the greatest number of B x - w.
  double (*forces)(const Problem& problem, std::span<Vector3d> out);
  // After kBalanced: the greatest t for which the contacts still hold w + t h; infinity if all. y: what supports their cone there,
  // y.h = 1.
  double (*reach)(const Problem& problem, const std::array<double, 6>& h, std::array<double, 6>& y);
};

// The widest one that this machine runs; or, for tests, that of 2, 4 or 8 numbers a vector, null if it does not run here.
const Kernel& kernel();
const Kernel* kernel_of_width(int width);

}  // namespace foothold::contact::simplex

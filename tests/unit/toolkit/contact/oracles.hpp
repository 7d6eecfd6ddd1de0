// Judges of equilibrium that share nothing with ours: CLP in double precision, cddlib in exact rational numbers.
#pragma once

#include <Eigen/Core>
#include <memory>

namespace foothold::contact {

using Generators = Eigen::Matrix<double, 6, Eigen::Dynamic>;
using Wrench = Eigen::Matrix<double, 6, 1>;

// CLP's primal simplex for: columns >= 0 whose sum is w. Keeps its model, as long as the number of columns stays.
class Clp {
 public:
  Clp();
  ~Clp();
  bool holds(const Generators& columns, const Wrench& w);
  // The same by the dual simplex method.
  bool holds_by_dual(const Generators& columns, const Wrench& w);

 private:
  struct Model;
  void load(const Generators& columns, const Wrench& w);
  std::unique_ptr<Model> model_;
};

// Whether w is a sum of the columns with weights >= 0, decided in exact arithmetic on these very doubles (cddlib with GMP): the
// greatest y.w <= 1 with y.g <= 0 for every column is 0.
bool holds_exactly(const Generators& columns, const Wrench& w);

}  // namespace foothold::contact

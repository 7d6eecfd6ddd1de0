#include <gmp.h>

#include <stdexcept>

#include "oracles.hpp"
extern "C" {
#include <cddlib/setoper.h>
// which the next one needs before it
#include <cddlib/cdd.h>
}

namespace foothold::contact {

bool holds_exactly(const Generators& columns, const Wrench& w) {
  static const bool ready = (dd_set_global_constants(), true);
  if (!ready) return false;
  const long rows = columns.cols() + 1;
  dd_MatrixPtr matrix = dd_CreateMatrix(rows, 7);
  matrix->representation = dd_Inequality;
  for (long j = 0; j < columns.cols(); ++j)
    for (long k = 0; k < 6; ++k) mpq_set_d(matrix->matrix[j][k + 1], -columns(k, j));
  mpq_set_si(matrix->matrix[rows - 1][0], 1, 1);
  matrix->objective = dd_LPmax;
  for (long k = 0; k < 6; ++k) {
    mpq_set_d(matrix->matrix[rows - 1][k + 1], -w[k]);
    mpq_set_d(matrix->rowvec[k + 1], w[k]);
  }
  dd_ErrorType error = dd_NoError;
  dd_LPPtr lp = dd_Matrix2LP(matrix, &error);
  const bool solved = error == dd_NoError && dd_LPSolve(lp, dd_DualSimplex, &error) && lp->LPS == dd_Optimal;
  const bool holds = solved && mpq_sgn(lp->optvalue) == 0;
  dd_FreeLPData(lp);
  dd_FreeMatrix(matrix);
  if (!solved) throw std::runtime_error("cddlib did not solve the program");
  return holds;
}

}  // namespace foothold::contact

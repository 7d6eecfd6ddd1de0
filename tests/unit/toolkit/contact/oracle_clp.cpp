#include <coin/ClpSimplex.hpp>
#include <vector>

#include "oracles.hpp"

namespace foothold::contact {

struct Clp::Model {
  ClpSimplex simplex;
  std::vector<int> starts, rows;
  Eigen::Index columns = -1;
};

Clp::Clp() : model_(std::make_unique<Model>()) {
  model_->simplex.setLogLevel(0);
  model_->simplex.setPrimalTolerance(1e-9);
}
Clp::~Clp() = default;

void Clp::load(const Generators& columns, const Wrench& w) {
  Model& m = *model_;
  if (m.columns != columns.cols()) {
    m.columns = columns.cols();
    m.starts.clear();
    m.rows.clear();
    for (int j = 0; j <= columns.cols(); ++j) m.starts.push_back(6 * j);
    for (int j = 0; j < columns.cols(); ++j)
      for (int i = 0; i < 6; ++i) m.rows.push_back(i);
    m.simplex.loadProblem(static_cast<int>(columns.cols()), 6, m.starts.data(), m.rows.data(), columns.data(), nullptr, nullptr,
                          nullptr, w.data(), w.data());
    return;
  }
  std::copy(columns.data(), columns.data() + columns.size(), m.simplex.matrix()->getMutableElements());
  std::copy(w.data(), w.data() + 6, m.simplex.rowLower());
  std::copy(w.data(), w.data() + 6, m.simplex.rowUpper());
  m.simplex.allSlackBasis(true);
}

bool Clp::holds(const Generators& columns, const Wrench& w) {
  load(columns, w);
  model_->simplex.primal();
  return model_->simplex.status() == 0;
}

bool Clp::holds_by_dual(const Generators& columns, const Wrench& w) {
  load(columns, w);
  model_->simplex.dual();
  return model_->simplex.status() == 0;
}

}  // namespace foothold::contact

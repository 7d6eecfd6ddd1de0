// Reading a robot's numbers: every miss names the path, what was wanted and what is there.
#include "foothold/model.hpp"

#include "foothold/errors.hpp"

namespace foothold {

const std::vector<double>& RobotModel::numbers(std::string_view path, std::string_view unit, std::size_t count) const {
  const auto found = quantities_.find(path);
  if (found == quantities_.end()) throw InvalidModel(std::string(path), "is missing");
  const Quantity& quantity = found->second;
  if (quantity.unit != unit) throw InvalidModel(std::string(path), "must be in " + std::string(unit) + ", is in " + quantity.unit);
  if (count != 0 && quantity.values.size() != count)
    throw InvalidModel(std::string(path), "must hold " + std::to_string(count) + (count == 1 ? " number" : " numbers") +
                                              ", holds " + std::to_string(quantity.values.size()));
  return quantity.values;
}

double RobotModel::number(std::string_view path, std::string_view unit) const { return numbers(path, unit, 1).front(); }

bool RobotModel::has(std::string_view path) const { return quantities_.find(path) != quantities_.end(); }

const std::string& RobotModel::text(std::string_view path) const {
  const auto found = texts_.find(path);
  if (found == texts_.end()) throw InvalidModel(std::string(path), "is missing");
  return found->second;
}

bool RobotModel::has_text(std::string_view path) const { return texts_.find(path) != texts_.end(); }

}  // namespace foothold

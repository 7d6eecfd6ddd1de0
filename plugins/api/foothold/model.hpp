// The numbers of a robot, read from config/robots/<name>.yaml by the host and handed to the planner's constructor in SI units.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace foothold {

// One entry of `model:` in a robot's file: one number or a list of numbers of the same unit, already in SI.
struct Quantity {
  std::vector<double> values;
  std::string unit;    // SI: m, rad, kg, s, N, 1 ...
  std::string source;  // paper, public, derived, assumed: which, in words
};

// All entries by dotted path ("piston.retracted"), and the texts of files that the robot's file names ("urdf"). Reading what is not
// there, or in another unit, throws InvalidModel with the path. Immutable; any thread may read it.
class RobotModel {
 public:
  RobotModel() = default;
  explicit RobotModel(std::map<std::string, Quantity, std::less<>> quantities,
                      std::map<std::string, std::string, std::less<>> texts = {})
      : quantities_(std::move(quantities)), texts_(std::move(texts)) {}

  // One number that must be in `unit` ("m", "rad", "kg", "1", ...). Throws InvalidModel.
  double number(std::string_view path, std::string_view unit) const;
  // A list of exactly `count` numbers (0: any count). Throws InvalidModel.
  const std::vector<double>& numbers(std::string_view path, std::string_view unit, std::size_t count = 0) const;
  bool has(std::string_view path) const;
  // The content of a file named at `path`. Throws InvalidModel.
  const std::string& text(std::string_view path) const;
  bool has_text(std::string_view path) const;
  const std::map<std::string, Quantity, std::less<>>& quantities() const { return quantities_; }
  const std::map<std::string, std::string, std::less<>>& texts() const { return texts_; }

 private:
  std::map<std::string, Quantity, std::less<>> quantities_;
  std::map<std::string, std::string, std::less<>> texts_;
};

}  // namespace foothold

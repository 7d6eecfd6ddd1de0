// Figures as text for Prometheus: the text format 0.0.4 of prometheus.io/docs/instrumenting/exposition_formats.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace foothold::server {

using Labels = std::vector<std::pair<std::string_view, std::string_view>>;

// How often something took how long. Bounds in seconds, each included in its bucket.
class Histogram {
 public:
  static constexpr std::array kBounds = {1e-4, 2.5e-4, 5e-4, 1e-3, 2.5e-3, 5e-3, 0.01, 0.025, 0.05,
                                         0.1,  0.25,   0.5,  1.0,  2.5,    5.0,  10.0, 30.0,  60.0};
  void add(double seconds);
  std::uint64_t count() const { return count_; }
  double sum() const { return sum_; }
  // How many took kBounds[i] or less.
  std::uint64_t up_to(std::size_t i) const;

 private:
  std::array<std::uint64_t, kBounds.size()> counts_{};  // of each bucket alone; what is longer is in count_ only
  std::uint64_t count_ = 0;
  double sum_ = 0.0;
};

class Exposition {
 public:
  enum class Kind { kCounter, kGauge, kHistogram };

  // The samples that follow are of this family. Names are the caller's: [a-z_]+.
  void family(std::string_view name, Kind kind, std::string_view help);
  void sample(const Labels& labels, double value);
  void sample(const Labels& labels, std::uint64_t value);
  void sample(const Labels& labels, const Histogram& histogram);

  const std::string& text() const { return text_; }

 private:
  void line(std::string_view ending, const Labels& labels, std::string_view value);

  std::string text_, name_;
};

}  // namespace foothold::server

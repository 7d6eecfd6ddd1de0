// Figures as text for Prometheus.
#include "metrics/exposition.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace foothold::server {
namespace {

std::string number(double value) {
  if (std::isnan(value)) return "NaN";
  if (std::isinf(value)) return value > 0 ? "+Inf" : "-Inf";
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.9g", value);
  return text.data();
}

// Of help texts and, with the quotes, of label values.
std::string escaped(std::string_view text, bool quotes) {
  std::string out;
  for (const char c : text) {
    if (c == '\\' || (quotes && c == '"')) out += '\\';
    if (c == '\n')
      out += "\\n";
    else
      out += c;
  }
  return out;
}

}  // namespace

void Histogram::add(double seconds) {
  const auto bucket = std::ranges::lower_bound(kBounds, seconds);
  if (bucket != kBounds.end()) ++counts_[static_cast<std::size_t>(bucket - kBounds.begin())];
  ++count_;
  sum_ += seconds;
}

std::uint64_t Histogram::up_to(std::size_t i) const {
  std::uint64_t sum = 0;
  for (std::size_t k = 0; k <= i; ++k) sum += counts_[k];
  return sum;
}

void Exposition::family(std::string_view name, Kind kind, std::string_view help) {
  name_ = name;
  const char* type = kind == Kind::kCounter ? "counter" : kind == Kind::kGauge ? "gauge" : "histogram";
  text_ += "# HELP " + name_ + " " + escaped(help, false) + "\n# TYPE " + name_ + " " + type + "\n";
}

void Exposition::line(std::string_view ending, const Labels& labels, std::string_view value) {
  text_ += name_;
  text_ += ending;
  if (!labels.empty()) {
    char before = '{';
    for (const auto& [name, content] : labels) {
      text_ += before;
      text_ += name;
      text_ += "=\"" + escaped(content, true) + '"';
      before = ',';
    }
    text_ += '}';
  }
  text_ += ' ';
  text_ += value;
  text_ += '\n';
}

void Exposition::sample(const Labels& labels, double value) { line("", labels, number(value)); }
void Exposition::sample(const Labels& labels, std::uint64_t value) { line("", labels, std::to_string(value)); }

void Exposition::sample(const Labels& labels, const Histogram& histogram) {
  Labels with_bound = labels;
  with_bound.emplace_back("le", "");
  for (std::size_t i = 0; i < Histogram::kBounds.size(); ++i) {
    const std::string bound = number(Histogram::kBounds[i]);
    with_bound.back().second = bound;
    line("_bucket", with_bound, std::to_string(histogram.up_to(i)));
  }
  with_bound.back().second = "+Inf";
  line("_bucket", with_bound, std::to_string(histogram.count()));
  line("_sum", labels, number(histogram.sum()));
  line("_count", labels, std::to_string(histogram.count()));
}

}  // namespace foothold::server

// Small text rules of the configuration.
#include "config/words.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>

namespace foothold::server {
namespace {

using Unit = std::pair<std::string_view, double>;
constexpr Unit kTimes[] = {{"ms", 1e-3}, {"s", 1.0}, {"min", 60.0}, {"h", 3600.0}, {"d", 86400.0}};
constexpr Unit kSizes[] = {{"B", 1.0},      {"kB", 1e3},        {"MB", 1e6},          {"GB", 1e9},
                           {"KiB", 1024.0}, {"MiB", 1048576.0}, {"GiB", 1073741824.0}};

std::optional<double> parse_quantity(std::string_view text, std::span<const Unit> units) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || !std::isfinite(value)) return std::nullopt;
  std::string_view unit(end, static_cast<std::size_t>(text.data() + text.size() - end));
  if (unit.empty()) return value;
  while (!unit.empty() && unit.front() == ' ') unit.remove_prefix(1);
  const auto found = std::ranges::find(units, unit, &Unit::first);
  if (found == units.end() || !std::isfinite(value * found->second)) return std::nullopt;
  return value * found->second;
}

// Levenshtein's distance if it is below `limit`, else `limit`: most names that are compared have nothing in common.
std::size_t distance(std::string_view a, std::string_view b, std::size_t limit) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    std::size_t left = i + 1, least = left;
    row[0] = left;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t change = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      left = std::min(change, std::min(diagonal, left) + 1);
      least = std::min(least, left);
      row[j + 1] = left;
    }
    if (least >= limit) return limit;  // no row has less than the one before
  }
  return std::min(row.back(), limit);
}

}  // namespace

std::optional<double> parse_seconds(std::string_view text) { return parse_quantity(text, kTimes); }
std::optional<double> parse_octets(std::string_view text) { return parse_quantity(text, kSizes); }
std::optional<double> parse_number(std::string_view text) { return parse_quantity(text, {}); }

std::string nearest(std::string_view name, const std::vector<std::string>& known) {
  std::string best;
  std::size_t least = std::max<std::size_t>(1, name.size() / 3) + 1;
  for (const auto& candidate : known) {
    // No fewer letters change than there are more or less of them; to count them takes the product of both lengths.
    if (std::max(name.size(), candidate.size()) - std::min(name.size(), candidate.size()) >= least) continue;
    const std::size_t changes = distance(name, candidate, least);
    if (changes >= least) continue;
    least = changes;
    best = candidate;
  }
  return best;
}

}  // namespace foothold::server

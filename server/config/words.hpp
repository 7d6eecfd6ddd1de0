// Small text rules of the configuration: quantities with units, and the nearest of known names.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace foothold::server {

// Seconds from "0.25", "250 ms", "10 s", "5 min", "2 h", "7 d". Nothing for anything else.
std::optional<double> parse_seconds(std::string_view text);
// Octets from "4096", "512 kB", "64 MB", "1 GB" (powers of 1000) or "512 KiB", "64 MiB", "1 GiB". Nothing for anything else.
std::optional<double> parse_octets(std::string_view text);
// A finite decimal number and nothing else.
std::optional<double> parse_number(std::string_view text);

// The known name that takes the fewest letters to change, if that is at most a third of them and one at least; else empty.
std::string nearest(std::string_view name, const std::vector<std::string>& known);

}  // namespace foothold::server

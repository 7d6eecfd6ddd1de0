// What the clients of the storm ask for: drawn from a seed, so that a client that vanished can be followed by one that asks for the
// same.
#pragma once

#include <foothold.h>

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "foothold/msg/cdr.hpp"
#include "foothold/msg/ids.hpp"

namespace foothold::faults {

enum class Kind { kShipped, kTally, kCrash, kHang, kMemory, kMalformed };
inline constexpr const char* kKindNames[] = {"shipped", "tally", "crash", "hang", "memory", "malformed"};

// A shipped request and how often it is asked for, relative to the others.
struct Choice {
  msg::PlanRequest request;
  double weight = 1.0;
};

struct Draw {
  Kind kind = Kind::kShipped;
  msg::PlanRequest request;
  enum class Cancel { kNo, kAtOnce, kAtFirstStep } cancel = Cancel::kNo;
};

// The k-th request of a client: its id depends on client and k alone. `tally_file`: where the planner `tally` notes its requests.
Draw draw(const std::vector<Choice>& choices, std::uint32_t client, std::uint32_t k, const std::string& tally_file);

// Octets that are no PlanRequest, or one that nobody waits for, under an id of its own.
msg::Bytes spoilt_octets(std::mt19937_64& random);

// Lines "weight file" of request files.
std::vector<Choice> read_choices(const std::string& file);

}  // namespace foothold::faults

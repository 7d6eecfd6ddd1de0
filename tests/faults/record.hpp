// What a client of the storm notes of each request when it has ended: one line in a file.
#pragma once

#include <foothold.h>

#include <cstdint>
#include <map>
#include <string>

#include "foothold/msg/cdr.hpp"
#include "foothold/msg/ids.hpp"

namespace foothold::faults {

struct Outcome {
  std::string kind, robot;
  std::uint32_t state = 0;
  std::uint16_t code = 0;  // of the error
  std::uint32_t steps = 0;
  std::string chain;   // of the steps' octets
  std::string reason;  // the error's message
};

// The chain of a plan's steps: begins empty, and takes each step in order.
inline void extend_chain(std::string& chain, const msg::Bytes& step) {
  chain = msg::sha256_hex(chain + std::string(reinterpret_cast<const char*>(step.data()), step.size()));
}

// One write, so that a client that is killed leaves whole lines.
void note(const std::string& file, const msg::Id& id, const Outcome& outcome);

// Throws std::runtime_error if a request is there twice or a line is not one.
std::map<msg::Id, Outcome> read_record(const std::string& file);

}  // namespace foothold::faults

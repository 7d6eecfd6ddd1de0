// Attackers, and what came of them.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "child.hpp"
#include "foothold/msg/ids.hpp"

namespace foothold::test {

// A row of the table.
struct Outcome {
  std::string attack, server, attacker;
  unsigned sent = 0;                             // messages that the attacker's own library took
  unsigned plans = 0;                            // that the server accepted from it
  unsigned steps = 0, events = 0, requests = 0;  // of others that it read
  unsigned forged = 0;                           // messages of its own that clients took for the server's
  std::string note;                              // what its own library said
  bool nothing() const { return plans == 0 && steps == 0 && events == 0 && requests == 0 && forged == 0; }
};

struct Victim {
  std::string partition;
  msg::Id request;
};

struct AttackerOptions {
  std::string attack;  // the row's name
  std::string vendor;
  std::uint32_t domain = 0;
  std::string credentials;  // empty: none
  std::string acts;         // read, request, serve; joined by commas
};

class Attacker {
 public:
  Attacker(const AttackerOptions& options, const std::vector<Victim>& victims, const std::filesystem::path& output);
  const AttackerOptions& options() const { return options_; }
  const msg::Id& id() const { return id_; }  // of the plan that it requests
  // True when it has begun, or was refused by its own library.
  bool begun() const;
  // Ends it and tells what it read and sent.
  Outcome finish();

 private:
  AttackerOptions options_;
  msg::Id id_ = msg::random_id();
  std::filesystem::path output_;
  std::unique_ptr<Child> child_;
};

void print_table(const std::vector<Outcome>& rows);

}  // namespace foothold::test

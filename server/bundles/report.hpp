// The report of a bundle, as text for people.
#pragma once

#include <string>
#include <vector>

#include "jobs/ports.hpp"

namespace foothold::server {

struct Incident {
  msg::PlanRequest request;
  msg::PlanEvent end;
  std::string why;                     // in words
  std::string server;                  // version and id
  double waited = 0.0, planned = 0.0;  // s
  std::vector<std::string> log;
};

std::string report_of(const Incident& incident);

// From the message of an error: "SIGSEGV", or empty.
std::string signal_in(const std::string& message);
// The last words that it holds, line by line: a crash's backtrace among them.
std::vector<std::string> last_words_in(const std::string& message);

}  // namespace foothold::server

// How every bench ends: a table for people, then one line of JSON.
#pragma once

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace foothold::bench {

struct Figure {
  std::string name;
  double value = 0.0;
  std::string unit;
  std::string better;  // less or more
  std::optional<double> goal;
  std::optional<double> baseline;
  std::string baseline_name;
};

// Prints the figures, those that miss their goal marked so, and the JSON as the last line of stdout. The commit is asked of git
// when the bench runs; "unknown" outside a checkout.
void report(const std::string& bench, const std::vector<Figure>& figures);

// True if the command line has --quick: a run under 30 s. `options`: what else it may have, each with one word behind it, as
// "--soak SECONDS". --help says what may stand there and ends the program; anything else ends it with exit code 2.
bool quick(int count, char** words, const std::vector<std::string>& options = {});

// The word behind `option`; nothing if it is not there.
std::optional<std::string> word_of(const char* option, int count, char** words);

// The value below which `part` (0..1) of the values lie. Precondition: not empty.
double percentile(std::vector<double> values, double part);

// Time of the calling thread on its processor: what other work on the machine does not lengthen.
double cpu_seconds();

// Of some runs of the same work the shortest, s.
template <class Work>
double least_seconds(int runs, Work&& work) {
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < runs; ++k) {
    const double begin = cpu_seconds();
    work();
    least = std::min(least, cpu_seconds() - begin);
  }
  return least;
}

}  // namespace foothold::bench

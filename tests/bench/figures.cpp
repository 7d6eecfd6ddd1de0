// The report of a bench, and order statistics.
#include "figures.hpp"

#include <ctime>

#include <sys/utsname.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>

namespace foothold::bench {
namespace {

// "2 x <processor>, Linux <release>".
std::string machine() {
  std::string model = "unknown processor";
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("model name")) {
      model = line.substr(line.find(':') + 2);
      break;
    }
  }
  utsname system{};
  uname(&system);
  return std::to_string(std::thread::hardware_concurrency()) + " x " + model + ", Linux " + system.release;
}

std::string commit() {
  const std::unique_ptr<FILE, int (*)(FILE*)> git(popen("git -C '" FOOTHOLD_SOURCE "' describe --always --dirty 2>/dev/null", "r"),
                                                  pclose);
  std::array<char, 128> text{};
  if (!git || std::fgets(text.data(), text.size(), git.get()) == nullptr) return "unknown";
  text[std::strcspn(text.data(), "\n")] = '\0';
  return text.data();
}

bool misses(const Figure& figure) {
  if (!figure.goal) return false;
  return figure.better == "less" ? figure.value > *figure.goal : figure.value < *figure.goal;
}

}  // namespace

void report(const std::string& bench, const std::vector<Figure>& figures) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  std::printf("\n%-40s %14s %-8s %14s %14s\n", "figure", "value", "unit", "goal", "baseline");
  for (const Figure& figure : figures) {
    nlohmann::ordered_json entry = {
        {"name", figure.name}, {"value", figure.value}, {"unit", figure.unit}, {"better", figure.better}};
    std::array<char, 32> goal{};
    std::array<char, 32> baseline{};
    if (figure.goal) {
      entry["goal"] = *figure.goal;
      std::snprintf(goal.data(), goal.size(), "%.6g", *figure.goal);
    }
    if (figure.baseline) {
      entry["baseline"] = *figure.baseline;
      entry["baseline_name"] = figure.baseline_name;
      std::snprintf(baseline.data(), baseline.size(), "%.6g", *figure.baseline);
    }
    std::printf("%-40s %14.6g %-8s %14s %14s %s%s\n", figure.name.c_str(), figure.value, figure.unit.c_str(), goal.data(),
                baseline.data(), figure.baseline_name.c_str(), misses(figure) ? "  MISSES ITS GOAL" : "");
    list.push_back(std::move(entry));
  }
  const nlohmann::ordered_json line = {{"bench", bench}, {"machine", machine()}, {"commit", commit()}, {"figures", list}};
  std::printf("%s\n", line.dump().c_str());
}

bool quick(int count, char** words, const std::vector<std::string>& options) {
  std::string usage = std::filesystem::path(words[0]).filename().string() + " [--quick]";
  for (const std::string& option : options) usage += " [" + option + "]";
  bool is_quick = false;
  for (int i = 1; i < count; ++i) {
    const std::string word = words[i];
    const auto known = [&](const std::string& option) { return option.substr(0, option.find(' ')) == word; };
    if (word == "--help" || word == "-h") {
      std::printf("%s\n", usage.c_str());
      std::exit(EXIT_SUCCESS);
    }
    if (word == "--quick") {
      is_quick = true;
    } else if (std::ranges::any_of(options, known) && i + 1 < count) {
      ++i;
    } else {
      std::fprintf(stderr, "'%s' is unknown or lacks its word: %s\n", word.c_str(), usage.c_str());
      std::exit(2);
    }
  }
  return is_quick;
}

std::optional<std::string> word_of(const char* option, int count, char** words) {
  for (int i = 1; i + 1 < count; ++i)
    if (std::strcmp(words[i], option) == 0) return words[i + 1];
  return std::nullopt;
}

double percentile(std::vector<double> values, double part) {
  const auto at = static_cast<std::ptrdiff_t>(part * static_cast<double>(values.size() - 1) + 0.5);
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace foothold::bench

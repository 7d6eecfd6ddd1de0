// A fuzz target without libFuzzer, for the usual build: fuzz_<target> SECONDS FOLDER...
// Runs every file of the folders once, then files that are spoilt (cut, octets changed, pieces of one put into another) from a
// fixed seed until a count of runs is reached; SECONDS only ends it early on a slow machine. A finding ends the process; what was
// run is then left in <target>.finding.
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <memory>
#include <random>
#include <vector>

#include "fuzzing.hpp"

namespace {

namespace fs = std::filesystem;
using Octets = std::vector<std::uint8_t>;

constexpr std::size_t kSpoilt = 3000;

Octets current;
std::string finding;  // the file for it

// Octets that parsers stumble over.
constexpr std::string_view kPieces[] = {"&a ",
                                        "*a",
                                        "[",
                                        "{",
                                        "}",
                                        "\n",
                                        ": ",
                                        "- ",
                                        "\"",
                                        "1e999",
                                        "nan",
                                        "-1",
                                        "!!",
                                        "\xff\xff\xff\xff",
                                        std::string_view("\0\0\0\0", 4),
                                        "\xff\xff\xff\x7f"};

void leave_finding(int number) {
  if (FILE* file = std::fopen(finding.c_str(), "wb")) {
    std::fwrite(current.data(), 1, current.size(), file);
    std::fclose(file);
  }
  std::fprintf(stderr, "ended by signal %d; the input of %zu octets is in %s\n", number, current.size(), finding.c_str());
  ::_exit(1);
}

void run(Octets octets) {
  current = std::move(octets);
  // A copy of its own, so that a sanitizer sees reads behind its end.
  const std::unique_ptr<std::uint8_t[]> input(new std::uint8_t[current.size()]);
  std::copy(current.begin(), current.end(), input.get());
  LLVMFuzzerTestOneInput(input.get(), current.size());
}

Octets spoilt(const std::vector<Octets>& seeds, std::mt19937_64& random) {
  const auto below = [&](std::size_t bound) { return bound == 0 ? 0 : static_cast<std::size_t>(random() % bound); };
  Octets out = seeds[below(seeds.size())];
  for (std::size_t changes = 1 + below(4); changes > 0; --changes) {
    const auto at = static_cast<std::ptrdiff_t>(below(out.size() + 1));
    switch (below(5)) {
      case 0:
        out.resize(static_cast<std::size_t>(at));
        break;
      case 1:
        if (at < std::ssize(out)) out[static_cast<std::size_t>(at)] = static_cast<std::uint8_t>(random());
        break;
      case 2: {
        const std::string_view piece = kPieces[below(std::size(kPieces))];
        out.insert(out.begin() + at, piece.begin(), piece.end());
        break;
      }
      case 3: {
        const Octets& other = seeds[below(seeds.size())];
        const std::size_t begin = below(other.size()), count = below(std::min<std::size_t>(other.size() - begin, 200));
        out.insert(out.begin() + at, other.begin() + static_cast<std::ptrdiff_t>(begin),
                   other.begin() + static_cast<std::ptrdiff_t>(begin + count));
        break;
      }
      default:
        out.erase(out.begin() + at,
                  out.begin() + at +
                      static_cast<std::ptrdiff_t>(below(std::min<std::size_t>(out.size() - static_cast<std::size_t>(at), 50))));
    }
  }
  return out;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) return 64;
  finding = fs::path(argv[0]).filename().string() + ".finding";
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(std::stol(argv[1]));
  // A stack of its own: recursion without end is a finding, too.
  static std::array<char, 65536> stack;
  const stack_t other{.ss_sp = stack.data(), .ss_flags = 0, .ss_size = stack.size()};
  ::sigaltstack(&other, nullptr);
  struct sigaction action {};
  action.sa_handler = leave_finding;
  action.sa_flags = SA_ONSTACK;
  for (const int number : {SIGABRT, SIGSEGV, SIGFPE, SIGBUS, SIGILL}) ::sigaction(number, &action, nullptr);
  std::vector<Octets> seeds;
  for (int k = 2; k < argc; ++k) {
    std::vector<fs::path> files;
    if (fs::is_directory(argv[k]))
      for (const auto& entry : fs::directory_iterator(argv[k])) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    for (const fs::path& path : files) {
      std::ifstream file(path, std::ios::binary);
      seeds.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
    }
  }
  if (seeds.empty()) {
    std::cerr << "no seeds\n";
    return 1;
  }
  std::size_t runs = 0;
  for (const Octets& seed : seeds) {
    run(seed);
    ++runs;
  }
  std::mt19937_64 random(1);
  for (; runs < seeds.size() + kSpoilt && std::chrono::steady_clock::now() < end; ++runs) run(spoilt(seeds, random));
  std::cout << seeds.size() << " seeds, " << runs << " runs\n";
  return 0;
}

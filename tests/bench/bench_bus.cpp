// The bare bus of all four vendor pairs: round trip of a small message, samples per second of a step's size. bench_bus [--quick]
// [CLIENT SERVER]
#include <unistd.h>

#include <cstdio>

#include "echo.hpp"
#include "figures.hpp"

int main(int count, char** words) {
  using namespace foothold::bench;
  const bool is_quick = quick(count, words);
  const int round_trips = is_quick ? 1000 : 5000;
  const std::uint32_t samples = is_quick ? 20'000 : 60'000;
  const std::string vendors[] = {"cyclone", "fastdds"};
  std::uint32_t domain = 1 + static_cast<std::uint32_t>(getpid()) % 100;
  const bool one_pair = count >= 3 && words[count - 1][0] != '-' && words[count - 2][0] != '-';
  std::vector<Figure> figures;
  std::printf("%-20s %12s %12s %14s\n", "client -> server", "echo p50 us", "echo p99 us", "samples/s");
  for (const std::string& client : vendors) {
    for (const std::string& server : vendors) {
      if (one_pair && (client != words[count - 2] || server != words[count - 1])) continue;
      std::vector<double> times;
      {
        RawEcho echo({client, server, ++domain});
        for (int i = 0; i < 200; ++i) echo.round_trip();
        for (int i = 0; i < round_trips; ++i) times.push_back(echo.round_trip() * 1e6);
      }
      const double rate = throughput({client, server, ++domain}, samples, 300);
      const double p50 = percentile(times, 0.5);
      const double p99 = percentile(times, 0.99);
      std::printf("%-20s %12.1f %12.1f %14.0f\n", (client + " -> " + server).c_str(), p50, p99, rate);
      std::fflush(stdout);
      const std::string pair = "_" + client + "_" + server;
      figures.push_back({"echo_p50" + pair, p50, "us", "less"});
      figures.push_back({"echo_p99" + pair, p99, "us", "less"});
      figures.push_back({"samples_per_s" + pair, rate, "1/s", "more"});
    }
  }
  report("bus", figures);
}

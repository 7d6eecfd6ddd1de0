// See workload.hpp.
#include "workload.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <stdexcept>

#include "foothold/client/request_file.hpp"

namespace foothold::faults {
namespace {

constexpr double kBudget = 8.0;  // s, of what should succeed: a worker that hangs holds its robot up for so long

void set_parameter(msg::PlanRequest& request, const std::string& name, const std::string& value) {
  msg::Parameter parameter;
  parameter.name(name);
  parameter.value(value);
  request.parameters().push_back(parameter);
}

// Each breaks one rule of P4.
void spoil(msg::PlanRequest& request, std::uint64_t which) {
  msg::Pose pose;
  pose.orientation().w(1.0);
  switch (which % 8) {
    case 0:
      pose.position().x(std::numeric_limits<double>::quiet_NaN());
      request.goal().base({pose});
      break;
    case 1:
      pose.orientation().w(1.1);
      request.goal().base({pose});
      break;
    case 2:
      request.robot("no-such-robot");
      break;
    case 3:
      set_parameter(request, "no_such_parameter", "1");
      break;
    case 4:
      request.budget(-1.0);
      break;
    case 5:
      request.start().joints(std::vector<double>(300, 0.0));
      break;
    case 6:
      request.unit("a\nb");
      break;
    default:
      request.scene("no-such-scene");
  }
}

}  // namespace

Draw draw(const std::vector<Choice>& choices, std::uint32_t client, std::uint32_t k, const std::string& tally_file) {
  std::mt19937_64 random(std::uint64_t{client} << 32 | k);
  std::vector<double> weights;
  for (const Choice& choice : choices) weights.push_back(choice.weight);
  std::discrete_distribution<std::size_t> shipped(weights.begin(), weights.end());
  Draw out;
  const auto chance = random() % 1000;  // of a thousand
  out.kind = chance < 25    ? Kind::kMalformed
             : chance < 40  ? Kind::kCrash
             : chance < 50  ? Kind::kHang
             : chance < 55  ? Kind::kMemory
             : chance < 200 ? Kind::kTally
                            : Kind::kShipped;
  msg::PlanRequest& request = out.request;
  request = choices[shipped(random)].request;
  request.budget(kBudget);
  request.shapes(random() % 20 == 0);
  request.resume(false);
  if (out.kind != Kind::kShipped && out.kind != Kind::kMalformed) {
    request = {};
    request.robot(kKindNames[static_cast<int>(out.kind)]);
    request.budget(out.kind == Kind::kHang ? 0.3 : kBudget);
  }
  if (out.kind == Kind::kTally) {
    set_parameter(request, "file", tally_file);
    set_parameter(request, "steps", std::to_string(random() % 40));
  }
  if (out.kind == Kind::kCrash) set_parameter(request, "how", std::array{"segv", "abort", "exit", "kill"}[random() % 4]);
  if (out.kind == Kind::kMemory) set_parameter(request, "in", std::array{"pieces", "crumbs"}[random() % 2]);
  if (out.kind == Kind::kMalformed) spoil(request, random());
  request.id(msg::id_of("client " + std::to_string(client) + " request " + std::to_string(k)));
  request.seed(std::uint64_t{client} << 32 | k);
  request.priority(static_cast<std::int32_t>(random() % 3));
  if (out.kind == Kind::kShipped) {
    const auto fate = random() % 100;
    if (fate < 2) request.budget(0.001 * static_cast<double>(1 + random() % 50));
    if (fate >= 2 && fate < 5) out.cancel = fate == 2 ? Draw::Cancel::kAtOnce : Draw::Cancel::kAtFirstStep;
  }
  return out;
}

msg::Bytes spoilt_octets(std::mt19937_64& random) {
  msg::PlanRequest request;
  request.id(msg::random_id());
  request.client(msg::random_id());
  request.robot("no-such-robot");
  msg::Bytes octets = msg::encode(request);
  const auto below = [&](std::size_t bound) { return static_cast<std::size_t>(random() % bound); };
  switch (below(3)) {
    case 0:
      octets.resize(4 + below(octets.size() - 4));
      break;
    case 1:  // lengths that promise too much
      for (std::size_t at = 52 + 4 * below(4); at + 4 <= octets.size(); at += 32)
        std::fill_n(octets.begin() + std::ptrdiff_t(at), 4, std::byte{0x7f});
      break;
    default:
      octets.resize(4 + below(2000));
      for (std::size_t at = 4; at < octets.size(); ++at) octets[at] = static_cast<std::byte>(random());
  }
  return octets;
}

std::vector<Choice> read_choices(const std::string& file) {
  std::ifstream in(file);
  std::vector<Choice> out;
  double weight = 0.0;
  for (std::string path; in >> weight >> path;) out.push_back({client::read_request_file(path).request, weight});
  if (out.empty()) throw std::runtime_error(file + " holds no requests");
  return out;
}

}  // namespace foothold::faults

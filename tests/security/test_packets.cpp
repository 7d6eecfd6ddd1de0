// Replayed and forged packets, for every vendor pair: with security on none is taken for a message; with security off the same ones
// are, so that this could fail.
#include <gtest/gtest.h>

#include <random>
#include <thread>

#include "attacks.hpp"
#include "credentials.hpp"
#include "daemon.hpp"
#include "eventually.hpp"
#include "planners.hpp"
#include "vendor_pairs.hpp"
#include "wire.hpp"
#include "wiretap.hpp"

namespace foothold::test {
namespace {

using security::Role;

constexpr std::uint32_t kDomain = 26;
constexpr std::uint32_t kSteps = 20;
const bool kLong = std::getenv("FOOTHOLD_LONG") != nullptr;
const int kSpoilt = kLong ? 100 : 3;  // copies of each packet with octets changed in what is enciphered or signed

void let_it_settle() { std::this_thread::sleep_for(std::chrono::milliseconds(1500)); }

// A request and a step as they went over the wire in clear text, with who spoke: from these a forger makes his own.
struct Templates {
  std::string server, client;  // participants
  msg::Id request{};
  Packet asked, answered;
};

// A server, a client and a finished plan, with all that went over the wire.
class Session {
 public:
  Session(const VendorPair& vendors, const std::string& server_credentials, const std::string& client_credentials)
      : vendors_(vendors), client_credentials_(client_credentials) {
    options_ = {.vendor = vendors.server, .domain = kDomain, .robots = {good_robot("good", 2)}, .security = server_credentials};
    start();
    wire_ = connect();
    request_ = wire_->submit(paced_request("good", kSteps, 0.001));
    if (!wire_->final_event(request_) || !wire_->wait_for_steps(request_, kSteps)) throw std::runtime_error("no plan");
    let_it_settle();
    packets_ = wiretap_.packets();
    for (const Packet& packet : packets_)
      if (packet.sender() != server_) client_ = packet.sender();
  }

  // A server that has never heard of anything, on the same ports; the client is gone.
  void start_anew() {
    wire_.reset();
    daemon_.reset();
    start();
  }
  void return_client() { wire_ = connect(); }

  // Whether the server knows a plan of this id.
  bool knows(const msg::Id& id) {
    const std::size_t before = wire_->events(id).size();
    wire_->query(id);
    if (!wire_->wait_until(20.0, [&] { return wire_->events(id).size() > before; })) throw std::runtime_error("no answer");
    return wire_->events(id).back().message.state() != msg::UNKNOWN;
  }

  std::optional<Templates> templates() const {
    Templates found{server_, client_, request_, {}, {}};
    for (const Packet& packet : packets_) {
      if (!sequence_number(packet, request_)) continue;
      (packet.sender() == server_ ? found.answered : found.asked) = packet;
    }
    return found.asked.octets.empty() || found.answered.octets.empty() ? std::nullopt : std::optional(found);
  }

  const std::vector<Packet>& packets() const { return packets_; }
  const std::string& server() const { return server_; }
  const std::string& client() const { return client_; }
  const msg::Id& request() const { return request_; }
  Wire& wire() { return *wire_; }
  Daemon& daemon() { return *daemon_; }

 private:
  void start() {
    const std::size_t before = wiretap_.packets().size();
    daemon_ = std::make_unique<Daemon>(options_);
    const auto first = [&] {
      const auto packets = wiretap_.packets();
      return packets.size() > before ? std::optional(packets[before].sender()) : std::nullopt;
    };
    if (!eventually([&] { return first().has_value(); })) throw std::runtime_error("the server is not heard");
    server_ = *first();
  }
  std::unique_ptr<Wire> connect() const {
    const msg::Id id = client_credentials_.empty() ? msg::random_id() : client_id(client_credentials_, vendors_.client);
    auto wire = std::make_unique<Wire>(vendors_.client, kDomain, "", id, client_credentials_);
    if (!wire->connect("good")) throw std::runtime_error("the client does not reach its server");
    return wire;
  }

  VendorPair vendors_;
  std::string client_credentials_;
  DaemonOptions options_;
  Wiretap wiretap_;
  std::unique_ptr<Daemon> daemon_;
  std::unique_ptr<Wire> wire_;
  std::string server_, client_;
  msg::Id request_{};
  std::vector<Packet> packets_;
};

class Packets : public testing::TestWithParam<VendorPair> {
 protected:
  void SetUp() override {
    if (!Wiretap().works()) GTEST_SKIP() << "no CAP_NET_RAW here: packets can be neither read nor compared";
  }

  Outcome row(const std::string& attack) const {
    return {.attack = attack, .server = GetParam().server, .attacker = GetParam().client};
  }

  // A request under an id of its own and one more step, made of templates for those who speak now, under many numbers.
  Outcome forge(Session& session, const Templates& from, const std::string& name) {
    Outcome outcome = row(name);
    const msg::Id id = msg::random_id();
    const auto send = [&](const Packet& packet) {
      put_on_wire(replaced(replaced(packet, from.server, session.server()), from.client, session.client()));
      ++outcome.sent;
    };
    const std::size_t events = session.wire().events(session.request()).size(),
                      steps = session.wire().steps(session.request()).size();
    const std::uint32_t asked = *sequence_number(from.asked, from.request),
                        answered = *sequence_number(from.answered, from.request);
    for (std::uint32_t ahead = 1; ahead <= 8; ++ahead) {
      send(replaced(renumbered(from.asked, from.request, asked + ahead), from.request, id));
      send(replaced(renumbered(from.answered, from.request, answered + ahead), from.request, session.request()));
    }
    let_it_settle();
    outcome.plans = session.knows(id) ? 1 : 0;
    outcome.forged = static_cast<unsigned>(session.wire().steps(session.request()).size() - steps +
                                           session.wire().events(session.request()).size() - events);
    return outcome;
  }

  // All that was heard, as it was and spoilt, to those who said and heard it.
  Outcome replay(Session& session) {
    Outcome outcome = row("replayed and spoilt, to the same");
    const std::size_t events = session.wire().events(session.request()).size(), steps = session.wire().total_steps();
    std::mt19937_64 random(7);
    for (int copy = 0; copy <= kSpoilt; ++copy)
      for (Packet packet : session.packets()) {
        const auto parts = protected_parts(packet);
        if (copy > 0 && parts.empty()) continue;
        for (int change = 0; copy > 0 && change < 3; ++change) {
          const auto [begin, end] = parts[random() % parts.size()];
          packet.octets[begin + random() % (end - begin)] ^= static_cast<std::uint8_t>(1 + random() % 255);
        }
        put_on_wire(packet);
        if (++outcome.sent % 50 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(2));
      }
    let_it_settle();
    outcome.events = static_cast<unsigned>(session.wire().events(session.request()).size() - events);
    outcome.steps = static_cast<unsigned>(session.wire().total_steps() - steps);
    return outcome;
  }

  // What a client once sent, to a server that never heard it; directed to who it is now.
  Outcome replay_to_another(Session& session) {
    Outcome outcome = row("replayed, to a server started anew");
    const std::string before = session.server();
    session.start_anew();
    for (int round = 0; round < 3; ++round)
      for (const Packet& packet : session.packets()) {
        if (packet.sender() == before) continue;
        put_on_wire(replaced(packet, before, session.server()));
        ++outcome.sent;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      }
    let_it_settle();
    session.return_client();
    outcome.plans = session.knows(session.request()) ? 1 : 0;
    return outcome;
  }
};
INSTANTIATE_TEST_SUITE_P(Pairs, Packets, testing::ValuesIn(kVendorPairs), pair_name);

TEST_P(Packets, AreWorthNothingWhereSecurityIsOnAndAllWhereItIsOff) {
  const Fleet fleet;
  std::vector<Outcome> open, closed;
  Templates clear;
  {
    Session session(GetParam(), "", "");
    const auto found = session.templates();
    ASSERT_TRUE(found) << "the request and its steps are not on the wire in clear text";
    clear = *found;
    open.push_back(forge(session, clear, "off: forged from what was heard"));
    open.push_back(replay_to_another(session));
    open.back().attack = "off: " + open.back().attack;
  }
  {
    Session session(GetParam(), fleet.issue("yard-1", Role::kServer), fleet.issue("robot-7", Role::kClient));
    for (const Packet& packet : session.packets()) EXPECT_FALSE(packet.holds(session.request())) << "an id can be read on the wire";
    closed.push_back(forge(session, clear, "forged in clear text"));
    closed.push_back(replay(session));
    const msg::Id next = session.wire().submit(paced_request("good", kSteps, 0.001));
    EXPECT_TRUE(session.wire().wait_for_steps(next, kSteps)) << "the attack stops who is attacked";
    closed.push_back(replay_to_another(session));
    EXPECT_TRUE(session.daemon().running());
  }
  std::vector<Outcome> all = open;
  all.insert(all.end(), closed.begin(), closed.end());
  print_table(all);
  EXPECT_EQ(open[0].plans, 1u);
  EXPECT_GT(open[0].forged, 0u);
  EXPECT_EQ(open[1].plans, 1u);
  for (const Outcome& outcome : closed) EXPECT_TRUE(outcome.nothing()) << outcome.attack;
}

}  // namespace
}  // namespace foothold::test

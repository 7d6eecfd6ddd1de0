// The table of attacks: who is not let in, or not for that, gets no plan, reads nothing and is believed by nobody; and the same
// attackers do all of it where security is off, so that the table could fail.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <thread>

#include "attacks.hpp"
#include "credentials.hpp"
#include "daemon.hpp"
#include "documents.hpp"
#include "eventually.hpp"
#include "files.hpp"
#include "planners.hpp"
#include "signing.hpp"
#include "vendor_pairs.hpp"
#include "wire.hpp"

namespace foothold::test {
namespace {

using security::Role;
namespace fs = std::filesystem;

constexpr std::uint32_t kDomain = 24;
const bool kLong = std::getenv("FOOTHOLD_LONG") != nullptr;
// How long an attack goes on after all attackers have begun, s. A permitted reader, which comes at the same time, must have read
// something by then.
const double kDuration = kLong ? 30.0 : 4.0;

// One server with two clients, one of each vendor, each with a plan that goes on; attackers around them.
class Siege {
 public:
  Siege(const std::string& server_vendor, const std::string& server_credentials, const std::string& client_credentials)
      : daemon_({.vendor = server_vendor, .domain = kDomain, .robots = {good_robot("good", 3)}, .security = server_credentials}) {
    for (const std::string& vendor : kVendors) {
      const msg::Id id = client_credentials.empty() ? msg::random_id() : client_id(client_credentials, vendor);
      clients_.push_back(std::make_unique<Wire>(vendor, kDomain, "", id, client_credentials));
    }
    const double lasts = kDuration + 120.0;  // s: longer than attackers on a busy machine need to begin and to end
    const auto steps = static_cast<std::uint32_t>(100.0 * lasts);
    for (const auto& client : clients_) {
      if (!client->connect("good", 30.0)) throw std::runtime_error("a client does not reach its server");
      msg::PlanRequest request = paced_request("good", steps, 0.01);
      request.budget(lasts + 60.0);
      victims_.push_back({msg::to_hex(client->id()), client->submit(request)});
      if (!client->wait_for_steps(victims_.back().request, 5)) throw std::runtime_error("no plan to attack");
    }
  }

  void attack(const AttackerOptions& options) {
    attackers_.push_back(
        std::make_unique<Attacker>(options, victims_, folder_ / ("attacker-" + std::to_string(attackers_.size()))));
  }

  std::vector<Outcome> outcomes() {
    for (const auto& attacker : attackers_)
      if (!eventually([&] { return attacker->begun(); }, 30.0)) throw std::runtime_error("an attacker does not begin");
    std::this_thread::sleep_for(std::chrono::duration<double>(kDuration));
    std::vector<Outcome> rows;
    for (const auto& attacker : attackers_) {
      rows.push_back(attacker->finish());
      rows.back().server = daemon_.options().vendor;
      rows.back().plans = accepted(attacker->id()) ? 1 : 0;
      rows.back().forged = forged(attacker->id());
    }
    return rows;
  }

  // Within the lease of the attackers: one that was let in, and died, holds up what it read beyond the writer's history until then.
  bool plans_go_on() {
    for (std::size_t i = 0; i < clients_.size(); ++i) {
      for (const auto& event : clients_[i]->events(victims_[i].request))
        if (is_final(event.message.state()) && !event.message.error().message().starts_with("forged")) return false;
      const std::size_t before = clients_[i]->steps(victims_[i].request).size();
      if (!clients_[i]->wait_until(40.0, [&] { return clients_[i]->steps(victims_[i].request).size() > before; })) return false;
    }
    return true;
  }
  Daemon& daemon() { return daemon_; }

 private:
  // What the clients took for the server's.
  unsigned forged(const msg::Id& attacker) const {
    const std::string label = "forged " + msg::to_hex(attacker);
    unsigned count = 0;
    for (std::size_t i = 0; i < clients_.size(); ++i) {
      count += clients_[i]->heard_of_server(label) ? 1 : 0;
      for (const auto& step : clients_[i]->steps(victims_[i].request)) count += step.message.label() == label ? 1 : 0;
      for (const auto& event : clients_[i]->events(victims_[i].request)) count += event.message.error().message() == label ? 1 : 0;
    }
    return count;
  }

  // The server itself knows whether it has ever accepted that id.
  bool accepted(const msg::Id& id) {
    Wire& asker = *clients_.front();
    asker.query(id);
    if (!asker.wait_until(20.0, [&] { return !asker.events(id).empty(); })) throw std::runtime_error("the server does not answer");
    return asker.events(id).back().message.state() != msg::UNKNOWN;
  }

  TemporaryFolder folder_;
  Daemon daemon_;
  std::vector<std::unique_ptr<Wire>> clients_;
  std::vector<Victim> victims_;
  std::vector<std::unique_ptr<Attacker>> attackers_;
};

class Attacks : public testing::TestWithParam<VendorPair> {
 protected:
  const std::string& server() const { return server_; }
  AttackerOptions as(const std::string& attack, const std::string& credentials, const std::string& acts) const {
    return {attack, GetParam().client, kDomain, credentials, acts};
  }

  // Credentials whose permissions are others: signed by the authority or by another.
  std::string with_permissions(const std::string& folder, const std::string& authority, const std::string& document) const {
    for (const std::string& vendor : kVendors) {
      const std::string file = security::credential_files(folder, vendor).permissions;
      const security::Authority from{security::key_from(security::read_file(authority + "/authority.key"), authority),
                                     security::certificate_from(security::read_file(authority + "/authority.crt"), authority)};
      const auto certificate =
          security::certificate_from(security::read_file(security::credential_files(folder, vendor).certificate), folder);
      std::string text = document;
      const std::string subject = security::subject_text(certificate.get());
      for (std::size_t at = text.find("SUBJECT"); at != std::string::npos; at = text.find("SUBJECT")) text.replace(at, 7, subject);
      security::replace(file, security::sign(from, text), security::Access::kEverybody);
    }
    return folder;
  }

  std::string server_ = GetParam().server;
  Fleet fleet_, foreign_;
};
INSTANTIATE_TEST_SUITE_P(Pairs, Attacks, testing::ValuesIn(kVendorPairs), pair_name);

std::string nothing_permitted() {
  std::string text = security::permissions_document({"nobody", "SUBJECT", Role::kClient, "", 0, 4102444800});
  const std::size_t begin = text.find("<publish>"), end = text.find("      </allow_rule>");
  return text.replace(begin, end - begin, "<publish><topics><topic>none</topic></topics></publish>\n");
}

TEST_P(Attacks, GetNothingWhereSecurityIsOn) {
  const std::string all = "read,request,serve";
  fleet_.issue("robot-6", Role::kClient);
  security::revoke(fleet_.authority(), "robot-6");  // who is issued credentials from now on has it in his list
  const std::string revoked = fleet_.authority() + "-robot-6";
  fs::copy(fs::path(fleet_.authority()).parent_path() / "robot-6", revoked);
  Siege siege(server(), fleet_.issue("yard-1", Role::kServer), fleet_.issue("robot-7", Role::kClient));
  siege.attack(as("permitted: an observer reads", fleet_.issue("viewer", Role::kObserver), "read"));
  siege.attack(as("permitted: another server serves", fleet_.issue("yard-2", Role::kServer), "request,serve"));
  siege.attack(as("unsecured", "", all));
  siege.attack(as("foreign authority, as server", foreign_.issue("yard-1", Role::kServer), all));
  siege.attack(as("client reads, asks and serves as others", fleet_.issue("robot-8", Role::kClient), all));
  siege.attack(as("observer requests and serves", fleet_.issue("viewer-2", Role::kObserver), "request,serve"));
  siege.attack(
      as("no permission", with_permissions(fleet_.issue("robot-9", Role::kClient), fleet_.authority(), nothing_permitted()), all));
  siege.attack(as("revoked", revoked, all));
  const std::vector<Outcome> rows = siege.outcomes();
  print_table(rows);
  for (const Outcome& row : rows) EXPECT_EQ(row.note, "opened, 0 endpoints refused at home") << row.attack;
  EXPECT_GT(rows[0].steps, 0u) << "the attackers had no time";
  EXPECT_GT(rows[0].events, 0u);
  EXPECT_GT(rows[1].forged, 0u) << "the attackers had no time";
  EXPECT_EQ(rows[1].plans, 0u) << "a server is no client";
  for (std::size_t i = 2; i < rows.size(); ++i) EXPECT_TRUE(rows[i].nothing()) << rows[i].attack;
  EXPECT_TRUE(siege.plans_go_on());
  EXPECT_TRUE(siege.daemon().running());
}

TEST_P(Attacks, SucceedWhereItIsOff) {
  Siege siege(server(), "", "");
  siege.attack(as("security is off", "", "read,request,serve"));
  const std::vector<Outcome> rows = siege.outcomes();
  print_table(rows);
  EXPECT_EQ(rows.front().plans, 1u);
  EXPECT_GT(rows.front().steps, 0u);
  EXPECT_GT(rows.front().events, 0u);
  EXPECT_GT(rows.front().requests, 0u);
  EXPECT_GT(rows.front().forged, 0u);
}

}  // namespace
}  // namespace foothold::test

// foothold security: an authority, and credentials by it. Asks no server.
#include <ctime>
#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "foothold/msg/times.hpp"
#include "foothold/security/authority.hpp"
#include "terminal.hpp"

namespace foothold::cli {
namespace {

using security::Issued;
using security::SecurityError;

template <class Work>
auto complaining(Work work) {
  try {
    return work();
  } catch (const SecurityError& error) {
    throw Complaint(Exit::kOther, error.what());
  }
}

constexpr const char* kDay = "%Y-%m-%d";

std::string standing(const Issued& issued) {
  if (issued.revoked) return "revoked";
  return (issued.expires < std::time(nullptr) ? "over since " : "valid until ") + msg::utc_text(issued.expires, kDay);
}

}  // namespace

Exit run_security_init(const SecurityOptions& options) {
  complaining([&] { security::create_authority({.folder = options.folder, .years = options.years}); });
  std::printf("made the authority %s\n", options.folder.c_str());
  std::printf("next: foothold security issue NAME --role server --authority %s -o DIR\n", options.folder.c_str());
  return Exit::kSucceeded;
}

Exit run_security_issue(const SecurityOptions& options) {
  const security::Role role = complaining([&] { return security::role_of(options.role); });
  complaining([&] {
    security::issue(
        {.authority = options.authority, .name = options.name, .role = role, .folder = options.output, .days = options.days});
  });
  std::printf("made the credentials of %s %s in %s\n", options.role.c_str(), options.name.c_str(), options.output.c_str());
  if (role == security::Role::kServer)
    std::puts(
        "next: copy that folder to the server's host, readable by footholdd's user alone, and name it in footholdd.yaml as "
        "dds.security");
  else
    std::puts("next: copy that folder to the host of its holder, and name it by --security or FOOTHOLD_SECURITY");
  return Exit::kSucceeded;
}

Exit run_security_revoke(const SecurityOptions& options) {
  complaining([&] { security::revoke(options.authority, options.name); });
  std::printf("revoked the credentials of %s\n", options.name.c_str());
  std::printf(
      "next: copy %s/revoked.crl over the one in everybody's credentials, the servers' first, and restart footholdd: until then "
      "it holds nowhere\n",
      options.authority.c_str());
  return Exit::kSucceeded;
}

Exit run_security_list(const Common& common, const SecurityOptions& options) {
  const std::vector<Issued> all = complaining([&] { return security::list_issued(options.authority); });
  std::vector<std::vector<std::string>> rows;
  for (const Issued& issued : all) {
    if (common.json)
      std::puts(nlohmann::ordered_json{{"credentials",
                                        {{"name", issued.name},
                                         {"role", security::name_of(issued.role)},
                                         {"expires", msg::utc_text(issued.expires, kDay)},
                                         {"revoked", issued.revoked}}}}
                    .dump()
                    .c_str());
    rows.push_back({issued.name, security::name_of(issued.role), standing(issued)});
  }
  if (!common.json && rows.empty()) std::puts("nobody was given credentials");
  if (!common.json) print_table(rows);
  return Exit::kSucceeded;
}

}  // namespace foothold::cli

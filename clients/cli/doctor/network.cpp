// Interfaces, and whether traffic can leave the host.
#include <arpa/inet.h>
#include <ifaddrs.h>
#include <net/if.h>
#include <netinet/in.h>

#include <algorithm>
#include <cstdlib>
#include <regex>

#include "check.hpp"
#include "foothold/client/whole_file.hpp"

namespace foothold::cli {
namespace {

using Level = Finding::Level;

std::vector<Interface> interfaces_of_this_machine() {
  std::vector<Interface> list;
  ifaddrs* all = nullptr;
  if (getifaddrs(&all) != 0) return list;
  for (const ifaddrs* entry = all; entry != nullptr; entry = entry->ifa_next) {
    auto known = std::ranges::find(list, std::string(entry->ifa_name), &Interface::name);
    if (known == list.end()) known = list.insert(list.end(), {entry->ifa_name, false, false, {}});
    known->up = (entry->ifa_flags & IFF_UP) != 0;
    known->loopback = (entry->ifa_flags & IFF_LOOPBACK) != 0;
    if (entry->ifa_addr == nullptr || entry->ifa_addr->sa_family != AF_INET) continue;
    char text[INET_ADDRSTRLEN] = {};
    inet_ntop(AF_INET, &reinterpret_cast<const sockaddr_in*>(entry->ifa_addr)->sin_addr, text, sizeof text);
    known->addresses.emplace_back(text);
  }
  freeifaddrs(all);
  return list;
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

bool is_local(const std::string& name) { return name == "lo" || name.starts_with("127."); }

// What a pattern captures, everywhere in the text.
std::vector<std::string> captures(const std::string& text, const char* pattern) {
  std::vector<std::string> found;
  const std::regex form(pattern, std::regex::icase);
  for (std::sregex_iterator match(text.begin(), text.end(), form), end; match != end; ++match) found.push_back((*match)[1]);
  return found;
}

// The interfaces that a vendor's file names; none named means all of them.
std::vector<std::string> named_interfaces(const std::string& vendor, std::string xml) {
  xml = std::regex_replace(xml, std::regex("<!--[^]*?-->"), "");
  if (vendor == "cyclone") return captures(xml, R"(<NetworkInterface[^>]*\b(?:name|address)\s*=\s*["']([^"']+)["'])");
  if (!captures(xml, R"(<useBuiltinTransports>\s*(true)\s*<)").empty()) return {};
  std::vector<std::string> named;
  for (const std::string& list : captures(xml, R"(<interfaceWhiteList>([^]*?)</interfaceWhiteList>)"))
    for (const std::string& address : captures(list, R"(>\s*([^<>\s]+)\s*<)")) named.push_back(address);
  return named;
}

}  // namespace

Surroundings this_machine() {
  Surroundings around;
  around.variable = [](const std::string& name) -> std::optional<std::string> {
    const char* value = std::getenv(name.c_str());
    if (value == nullptr || *value == '\0') return std::nullopt;
    return value;
  };
  around.interfaces = interfaces_of_this_machine();
  return around;
}

Findings check_interfaces(const Surroundings& around) {
  Findings findings;
  const auto loopback = std::ranges::find_if(around.interfaces, [](const Interface& i) {
    return i.loopback && i.up && std::ranges::find(i.addresses, "127.0.0.1") != i.addresses.end();
  });
  if (loopback == around.interfaces.end())
    findings.push_back({Level::kFail, "loopback", "no interface that is up has 127.0.0.1", "ip link set lo up"});
  else
    findings.push_back({Level::kOk, "loopback", loopback->name + " is up with 127.0.0.1", ""});
  std::vector<std::string> others;
  for (const Interface& i : around.interfaces)
    if (!i.loopback && i.up && !i.addresses.empty()) others.push_back(i.name + " " + joined(i.addresses));
  findings.push_back({Level::kOk, "interfaces", others.empty() ? "none but loopback" : "also up: " + joined(others), ""});
  return findings;
}

Findings check_exposure(const Common& common) {
  if (common.network.empty())
    return {{Level::kOk, "exposure", "loopback only: the built-in configuration sends nothing from this host", ""}};
  std::string xml;
  try {
    xml = client::read_whole_file(common.network);
  } catch (const std::system_error& error) {
    return {{Level::kFail, "exposure", common.network + ": cannot be read: " + error.code().message(),
             "name a configuration file of " + common.dds + ", or leave --network out for loopback"}};
  }
  std::vector<std::string> named = named_interfaces(common.dds, xml);
  const bool all = named.empty();
  std::erase_if(named, is_local);
  if (!all && named.empty()) return {{Level::kOk, "exposure", "loopback only, by " + common.network, ""}};
  return {{Level::kWarn, "exposure",
           "traffic leaves this host through " + (all ? "every interface" : joined(named)) + ", by " + common.network,
           "whoever reaches that network can submit, cancel and forge: keep it closed, or use DDS Security"}};
}

}  // namespace foothold::cli

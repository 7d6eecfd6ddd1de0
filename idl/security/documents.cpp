// The rules follow the table of who talks on which topic (idl/PROTOCOL.md).
#include "documents.hpp"

#include <array>
#include <ctime>
#include <vector>

#include "foothold/msg/times.hpp"
#include "foothold/transport/topics.hpp"

namespace foothold::security {
namespace {

constexpr const char* kXmlTime = "%Y-%m-%dT%H:%M:%S";

using transport::Topic;

// Above every domain that foothold takes.
constexpr const char* kDomains = "<domains><id_range><min>0</min><max>230</max></id_range></domains>";
constexpr const char* kSchema = "http://www.omg.org/spec/DDS-Security/20170901/omg_shared_ca_";

constexpr std::array kFromClients{Topic::kRequest, Topic::kCancel, Topic::kQuery, Topic::kScene};
constexpr std::array kToEverybody{Topic::kServer, Topic::kRobot, Topic::kSceneStatus};
constexpr std::array kAmongServers{Topic::kServer};
constexpr std::array kToOneClient{Topic::kEvent, Topic::kStep};

std::string head(const std::string& document) {
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<dds xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" "
         "xsi:noNamespaceSchemaLocation=\"" +
         std::string(kSchema) + document + ".xsd\">\n";
}

// `kind`: publish or subscribe. `partition` empty: the default one, and no other.
template <std::size_t count>
std::string rule(const char* kind, const std::array<Topic, count>& topics, const std::string& partition) {
  std::string text = "        <" + std::string(kind) + ">\n          <topics>";
  for (const Topic topic : topics) text += "<topic>" + std::string(transport::traits(topic).name) + "</topic>";
  text += "</topics>\n";
  if (!partition.empty()) text += "          <partitions><partition>" + partition + "</partition></partitions>\n";
  return text + "        </" + kind + ">\n";
}

std::string rules(const Grant& grant) {
  switch (grant.role) {
    case Role::kServer:
      return rule("publish", kToEverybody, "") + rule("publish", kToOneClient, "*") + rule("subscribe", kFromClients, "") +
             rule("subscribe", kAmongServers, "");
    case Role::kClient:
      return rule("publish", kFromClients, "") + rule("subscribe", kToEverybody, "") +
             rule("subscribe", kToOneClient, grant.prefix + "*");
    case Role::kObserver:
      break;
  }
  return rule("subscribe", kToEverybody, "") + rule("subscribe", kToOneClient, "*");
}

}  // namespace

std::string governance_document() {
  return head("governance") + "  <domain_access_rules>\n    <domain_rule>\n      " + kDomains +
         R"(
      <allow_unauthenticated_participants>false</allow_unauthenticated_participants>
      <enable_join_access_control>true</enable_join_access_control>
      <discovery_protection_kind>ENCRYPT</discovery_protection_kind>
      <liveliness_protection_kind>ENCRYPT</liveliness_protection_kind>
      <rtps_protection_kind>NONE</rtps_protection_kind>
      <topic_access_rules>
        <topic_rule>
          <topic_expression>*</topic_expression>
          <enable_discovery_protection>true</enable_discovery_protection>
          <enable_liveliness_protection>true</enable_liveliness_protection>
          <enable_read_access_control>true</enable_read_access_control>
          <enable_write_access_control>true</enable_write_access_control>
          <metadata_protection_kind>ENCRYPT</metadata_protection_kind>
          <data_protection_kind>ENCRYPT</data_protection_kind>
        </topic_rule>
      </topic_access_rules>
    </domain_rule>
  </domain_access_rules>
</dds>
)";
}

std::string permissions_document(const Grant& grant) {
  return head("permissions") + "  <permissions>\n    <grant name=\"" + grant.holder + "\">\n      <subject_name>" + grant.subject +
         "</subject_name>\n      <validity><not_before>" + msg::utc_text(grant.begins, kXmlTime) + "</not_before><not_after>" +
         msg::utc_text(grant.expires, kXmlTime) + "</not_after></validity>\n      <allow_rule>\n        " + kDomains + "\n" +
         rules(grant) + "      </allow_rule>\n      <default>DENY</default>\n    </grant>\n  </permissions>\n</dds>\n";
}

}  // namespace foothold::security

// Variables that DDS vendors and ROS read, and what they do to foothold.
#include "check.hpp"
#include "foothold/transport/bus.hpp"

namespace foothold::cli {
namespace {

using Level = Finding::Level;

struct Known {
  const char* name;
  Level level;
  const char* effect;
  const char* advice;
};

constexpr Known kKnown[] = {
    {"CYCLONEDDS_URI", Level::kOk, "not read by foothold, which brings its own configuration; other Cyclone programs obey it", ""},
    {"FASTRTPS_DEFAULT_PROFILES_FILE", Level::kOk, "loaded by Fast DDS, but foothold's participant takes nothing from it", ""},
    {"FASTDDS_DEFAULT_PROFILES_FILE", Level::kOk, "loaded by Fast DDS, but foothold's participant takes nothing from it", ""},
    {"ROS_DISCOVERY_SERVER", Level::kFail,
     "changes the discovery of Fast DDS whatever its settings say: foothold refuses to use it so",
     "unset ROS_DISCOVERY_SERVER, or use --dds cyclone"},
    {"FASTDDS_ENVIRONMENT_FILE", Level::kFail,
     "changes the discovery of Fast DDS whatever its settings say: foothold refuses to use it so",
     "unset FASTDDS_ENVIRONMENT_FILE, or use --dds cyclone"},
    {"RMW_IMPLEMENTATION", Level::kOk, "not read by foothold: --dds chooses the vendor", ""},
    {"ROS_LOCALHOST_ONLY", Level::kOk, "not read by foothold, which stays on loopback unless --network says otherwise", ""},
    {"FOOTHOLD_BUS_DIR", Level::kWarn, "the vendors' libraries are loaded from there and from nowhere else",
     "unset it unless you build foothold's bus yourself"},
};

}  // namespace

Findings check_environment(const Surroundings& around, const Common& common) {
  Findings findings;
  for (const Known& known : kKnown) {
    const auto value = around.variable(known.name);
    if (!value) continue;
    // What only Fast DDS obeys does no harm to a Cyclone client.
    const Level level = known.level == Level::kFail && common.dds != "fastdds" ? Level::kWarn : known.level;
    findings.push_back({level, known.name, "is " + *value + ": " + known.effect, known.advice});
  }
  if (const auto domain = around.variable("ROS_DOMAIN_ID"); domain && *domain != std::to_string(common.domain))
    findings.push_back({Level::kOk, "ROS_DOMAIN_ID",
                        "is " + *domain + ", not read by foothold, which is on domain " + std::to_string(common.domain) +
                            " (--domain, FOOTHOLD_DOMAIN)",
                        ""});
  if (findings.empty()) findings.push_back({Level::kOk, "environment", "no variable of DDS or ROS is set", ""});
  return findings;
}

}  // namespace foothold::cli

// Loading as a worker does it, and the descriptor as JSON.
#include "worker/describe.hpp"

#include <cstdio>
#include <cstring>
#include <memory>
#include <nlohmann/json.hpp>

#include "foothold/msg/errors.hpp"
#include "foothold/robot_file.hpp"
#include "worker/loader.hpp"
#include "worker/schema.hpp"

namespace foothold::server {
namespace {

using Json = nlohmann::ordered_json;

Json abi_json(const PluginAbi& abi) {
  return {
      {"api_version", abi.api_version},       {"compiler", std::string(abi.compiler, strnlen(abi.compiler, sizeof(abi.compiler)))},
      {"cxx11_abi", abi.cxx11_abi},           {"eigen_max_align", abi.eigen_max_align},
      {"sizeof_step", abi.sizeof_step},       {"alignof_step", abi.alignof_step},
      {"sizeof_request", abi.sizeof_request}, {"sizeof_report", abi.sizeof_report}};
}

const char* kind_name(msg::ParameterKind kind) {
  constexpr const char* kNames[] = {"flag", "integer", "real", "text", "choice"};
  return kNames[static_cast<std::size_t>(kind)];
}

Json parameter_json(const msg::ParameterSpec& spec) {
  Json out = {{"name", spec.name()},
              {"kind", kind_name(spec.kind())},
              {"unit", spec.unit()},
              {"default", spec.default_value()},
              {"description", spec.description()}};
  if (spec.kind() == msg::INTEGER || spec.kind() == msg::REAL) {
    out["minimum"] = spec.minimum();
    out["maximum"] = spec.maximum();
  }
  if (spec.kind() == msg::CHOICE) out["choices"] = spec.choices();
  return out;
}

Json plugin_json(const PluginDescriptor& plugin) {
  const msg::RobotInfo info = describe_robot("", plugin.info);
  Json out = {{"plugin", info.plugin()},
              {"version", info.plugin_version()},
              {"description", info.description()},
              {"joints", info.joints()},
              {"limbs", info.limbs()},
              {"start_needs", info.start_needs()},
              {"goal_needs", info.goal_needs()},
              {"prepare_parameters", words_of(plugin.info.prepare_parameters)}};
  out["parameters"] = Json::array();
  for (const msg::ParameterSpec& spec : info.parameters()) out["parameters"].push_back(parameter_json(spec));
  out["abi"] = abi_json(plugin.abi);
  return out;
}

int say(const Json& json, int code) {
  // A plugin's texts need not be UTF-8.
  std::puts(json.dump(2, ' ', false, Json::error_handler_t::replace).c_str());
  return code;
}

int refused(const std::string& message, const std::string& field = {}) {
  const msg::Error error = msg::make_error(msg::PLUGIN_REFUSED, message, field);
  return say({{"refused",
               {{"code", error.code()},
                {"name", error.name()},
                {"field", error.field()},
                {"message", error.message()},
                {"hint", error.hint()}}}},
             1);
}

}  // namespace

int describe(const std::string& plugin_path, const std::string& robot_file) {
  try {
    const PluginDescriptor& plugin = load_plugin(plugin_path);
    check_info(plugin.info);
    Json out = plugin_json(plugin);
    if (!robot_file.empty()) {
      const std::unique_ptr<Planner, void (*)(Planner*)> planner(plugin.create(load_robot_model(robot_file)), plugin.destroy);
      if (!planner) return refused("it made no planner");
      out["robot_file"] = robot_file;
    }
    return say(out, 0);
  } catch (const InvalidModel& fault) {
    return refused("model." + fault.field() + " " + fault.what(), "model." + fault.field());
  } catch (const FileError& fault) {
    return refused(fault.what(), fault.field());
  } catch (const std::exception& fault) {
    return refused(fault.what());
  } catch (...) {
    return refused("it threw something that is no std::exception");
  }
}

}  // namespace foothold::server

// footholdd.yaml.
#include <arpa/inet.h>

#include <array>
#include <filesystem>

#include "config/reading.hpp"
#include "config/section.hpp"

namespace foothold::server {
namespace {

constexpr Bounds kTime{0.0, 86400.0};
constexpr double kYear = 366 * 86400.0;

void read_dds(Section dds, DdsConfig& out) {
  dds.choice("vendor", out.vendor, {"cyclone", "fastdds"});
  std::size_t domain = out.domain;
  dds.count("domain", domain, {0, 200});
  out.domain = static_cast<std::uint32_t>(domain);
  dds.path("network_config", out.network_config, Section::Kind::kFile);
  dds.path("security", out.security, Section::Kind::kFolder);
  dds.end();
}

void read_admission(Section admission, AdmissionConfig& out) {
  admission.count("queued_per_client", out.queued_per_client, {1, 1e6});
  admission.count("running_per_client", out.running_per_client, {0, 1e6});
  admission.end();
}

void read_workers(Section workers, WorkersConfig& out) {
  workers.seconds("restart_first", out.restart_first, {0.001, 3600});
  workers.seconds("restart_longest", out.restart_longest, {0.001, 3600});
  workers.seconds("start_limit", out.start_limit, {0.1, 3600});
  workers.count("quarantine_crashes", out.quarantine_crashes, {1, 1e6});
  workers.seconds("quarantine_window", out.quarantine_window, {0.001, 86400});
  workers.seconds("quarantine_time", out.quarantine_time, {0.001, 86400});
  if (out.restart_longest < out.restart_first) workers.fault("restart_longest", "must not be below restart_first");
  workers.end();
}

void read_scenes(Section scenes, ScenesConfig& out) {
  scenes.octets("max_bytes", out.max_bytes, {1, 4e9});
  scenes.paths("preload", out.preload, Section::Kind::kFolder);
  scenes.end();
}

bool is_address(const std::string& text) {
  std::array<unsigned char, sizeof(in6_addr)> octets{};
  return inet_pton(AF_INET, text.c_str(), octets.data()) == 1 || inet_pton(AF_INET6, text.c_str(), octets.data()) == 1;
}

void read_metrics(Section metrics, MetricsConfig& out) {
  metrics.flag("enabled", out.enabled);
  metrics.text("address", out.address, 64);
  if (!is_address(out.address))
    metrics.fault("address", "must be an IP address as numbers, such as 127.0.0.1 (is '" + out.address + "')");
  std::size_t port = out.port;
  metrics.count("port", port, {0, 65535});
  out.port = static_cast<std::uint16_t>(port);
  metrics.end();
}

void read_bundles(Section bundles, BundlesConfig& out) {
  bundles.seconds("slow", out.slow, kTime);
  bundles.count("keep", out.keep, {0, 10000});
  bundles.end();
}

}  // namespace

ServerConfig read_server_config(const std::string& file) {
  Faults faults;
  ServerConfig config;
  if (const auto tree = load_yaml(file, faults)) {
    Section root(faults, file, *tree);
    root.text("name", config.name, 64);
    read_dds(root.section("dds"), config.dds);
    root.path("state_dir", config.state_dir);
    root.path("plugin_dir", config.plugin_dir, Section::Kind::kFolder);
    root.require("robots_dir");
    root.path("robots_dir", config.robots_dir, Section::Kind::kFolder);
    root.path("worker", config.worker, Section::Kind::kFile);
    root.count("queue_limit", config.queue_limit, {1, 1e6});
    root.seconds("budget_max", config.budget_max, {0.001, 7 * 86400.0});
    root.seconds("grace", config.grace, {0.001, 60});
    root.seconds("cancel_memory", config.cancel_memory, kTime);
    root.seconds("retention", config.retention, {1, 10 * kYear});
    read_admission(root.section("admission"), config.admission);
    read_workers(root.section("workers"), config.workers);
    read_scenes(root.section("scenes"), config.scenes);
    read_metrics(root.section("metrics"), config.metrics);
    read_bundles(root.section("bundles"), config.bundles);
    root.choice("log_level", config.log_level, {"trace", "debug", "info", "warn", "error", "off"});
    root.end();
  }
  if (!faults.empty()) throw ConfigError(faults);
  return config;
}

}  // namespace foothold::server

// What systemd is told, if it asked (NOTIFY_SOCKET): ready, stopping, still alive.
#pragma once

#include <chrono>
#include <optional>
#include <string>

namespace foothold::server::service {

void ready(const std::string& status);
void stopping();
void alive();
// How often alive() is wanted; nothing without a watchdog.
std::optional<std::chrono::microseconds> watchdog();

}  // namespace foothold::server::service

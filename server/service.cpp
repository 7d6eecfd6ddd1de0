// Words to systemd.
#include "service.hpp"

#include <systemd/sd-daemon.h>

namespace foothold::server::service {

void ready(const std::string& status) { sd_notify(0, ("READY=1\nSTATUS=" + status).c_str()); }
void stopping() { sd_notify(0, "STOPPING=1"); }
void alive() { sd_notify(0, "WATCHDOG=1"); }

}  // namespace foothold::server::service

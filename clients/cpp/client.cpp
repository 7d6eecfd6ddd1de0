// The public face of the client.
#include "foothold/client/client.hpp"

#include "client_impl.hpp"

namespace foothold::client {

Client::Client(std::unique_ptr<transport::Bus> bus, ClientOptions options)
    : impl_(std::make_unique<Impl>(std::move(bus), options)) {}
Client::~Client() = default;

const msg::Id& Client::id() const { return impl_->options.id; }
std::string Client::bus_version() const { return std::string(impl_->bus->vendor()) + " " + impl_->bus->version(); }

std::vector<ServerSeen> Client::servers() const { return impl_->directory.servers(); }
std::vector<msg::RobotInfo> Client::robots() const { return impl_->directory.robots(); }
std::vector<msg::SceneStatus> Client::scenes() const { return impl_->directory.scenes(); }

bool Client::wait_for_server(double seconds, const msg::Id& server) const { return impl_->directory.wait_open(seconds, server); }

std::optional<msg::RobotInfo> Client::wait_for_robot(std::string_view name, double seconds, const msg::Id& server) const {
  return impl_->directory.wait_robot(name, seconds, server);
}

void Client::wait_for_lists(double seconds, double quiet) const {
  using Seconds = std::chrono::duration<double>;
  const auto begin = Directory::Clock::now();
  const auto since = [](auto time) { return Seconds(Directory::Clock::now() - time).count(); };
  while (since(begin) < seconds) {
    const double calm = std::min(since(impl_->directory.changed()), since(begin));
    if (calm >= quiet) return;
    impl_->directory.wait_change(std::min(quiet - calm, seconds - since(begin)));
  }
}

Plan Client::submit(msg::PlanRequest request, PlanCallbacks callbacks) {
  return impl_->submit(std::move(request), std::move(callbacks));
}

Plan Client::query(const msg::Id& request, std::uint32_t from_step, PlanCallbacks callbacks) {
  return impl_->query(request, from_step, std::move(callbacks));
}

void Client::cancel(const msg::Id& request, const std::string& reason) {
  msg::CancelRequest cancel;
  cancel.id(request);
  cancel.client(impl_->options.id);
  cancel.reason(reason);
  impl_->outgoing->send(cancel);
}

}  // namespace foothold::client

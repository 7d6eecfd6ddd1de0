// The frames of a worker, in their order.
#include "worker/session.hpp"

#include <cstdio>
#include <memory>
#include <new>

#include "foothold/msg/errors.hpp"
#include "text/text.hpp"
#include "worker/confinement.hpp"
#include "worker/convert.hpp"
#include "worker/loader.hpp"
#include "worker/planning.hpp"
#include "worker/stop_watch.hpp"

namespace foothold::server {
namespace {

class Session {
 public:
  explicit Session(int socket) : channel_(socket), stop_watch_(channel_) {}

  // True if the plugin is loaded and the daemon knows it.
  bool load(const frame::Load& load) {
    try {
      limit_memory(load.memory_limit());
      const PluginDescriptor& plugin = load_plugin(load.plugin_path());
      check_info(plugin.info);
      planning_ = std::make_unique<Planning>(load.robot(), plugin, to_model(load));
      frame::Ready ready;
      ready.info(describe_robot(load.robot(), plugin.info));
      channel_.send(frame::READY, 0, ready);
      return true;
    } catch (const ChannelClosed&) {
      throw;
    } catch (const PluginRefused& fault) {
      refuse(fault.what(), "");
    } catch (const InvalidModel& fault) {
      refuse("model." + fault.field() + " " + fault.what(), "model." + fault.field());
    } catch (const std::bad_alloc&) {
      refuse("no memory left while it was loaded", "memory_limit");
    } catch (const std::exception& fault) {
      refuse(std::string("its constructor threw: ") + fault.what(), "");
    } catch (...) {
      refuse("its constructor threw something that is no std::exception", "");
    }
    return false;
  }

  // False if this process shall end.
  bool plan(std::uint64_t run, const frame::Plan& plan) {
    std::stop_source source;
    stop_watch_.begin(run, source);
    const frame::Report report = planning_->run(run, plan, source.get_token(), channel_);
    // Before the report goes: the answer to it is the next PLAN, which is the main thread's to read.
    stop_watch_.end();
    channel_.send(frame::REPORT, run, report);
    return !report.leave();
  }

  std::optional<Frame> read() { return channel_.read(); }

 private:
  void refuse(const std::string& reason, const std::string& field) {
    frame::Refused refused;
    refused.reason(msg::make_error(msg::PLUGIN_REFUSED, cleaned(reason), cleaned(field)));
    channel_.send(frame::REFUSED, 0, refused);
  }

  Channel channel_;
  StopWatch stop_watch_;
  std::unique_ptr<Planning> planning_;
};

template <class Message>
Message decoded(const Frame& frame) {
  auto message = msg::decode<Message>(frame.payload);
  if (!message) throw FrameFault("a " + frame_name(frame.kind) + " frame whose payload cannot be read");
  return std::move(*message);
}

int converse(Session& session) {
  const auto first = session.read();
  if (!first) return 0;
  if (first->kind != frame::LOAD) throw FrameFault("a " + frame_name(first->kind) + " frame before LOAD");
  if (!session.load(decoded<frame::Load>(*first))) return 0;
  while (const auto next = session.read()) {
    // A STOP that finds no run came after its report had gone.
    if (next->kind == frame::STOP) continue;
    if (next->kind != frame::PLAN) throw FrameFault("a " + frame_name(next->kind) + " frame after LOAD");
    if (!session.plan(next->run, decoded<frame::Plan>(*next))) return 0;
  }
  return 0;
}

}  // namespace

int serve(int socket) {
  try {
    Session session(socket);
    return converse(session);
  } catch (const ChannelClosed&) {
    return 0;
  } catch (const FrameFault& fault) {
    std::fprintf(stderr, "foothold-worker: the daemon sent %s\n", fault.what());
    return 2;
  } catch (const std::exception& fault) {
    std::fprintf(stderr, "foothold-worker: %s\n", fault.what());
    return 3;
  }
}

}  // namespace foothold::server

// Bus: the one interface behind which the two DDS vendors meet. It moves whole messages as CDR bytes (msg/cdr.hpp): what is a
// message, a request or a step is not its business.
//
// An implementation is a shared library, loaded by name at run time: open_bus({.vendor = "cyclone"}) or "fastdds".
// Nothing leaves 127.0.0.1 unless `network_config` names a vendor configuration that says otherwise.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

#include "foothold/transport/topics.hpp"

namespace foothold::transport {

// The bus cannot be opened or an entity cannot be made. The message says what to do.
class [[gnu::visibility("default")]] BusError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

inline constexpr std::uint32_t kMaxDomain = 200;

struct BusOptions {
  std::string vendor = "cyclone";  // cyclone or fastdds
  std::uint32_t domain = 0;        // 0 to kMaxDomain
  // A vendor's XML file that replaces the built-in loopback configuration. Empty: loopback.
  std::string network_config;
  // A folder of credentials (foothold/security/credentials.hpp): DDS Security is on, and only who has some of the same authority is
  // heard. Empty: no security.
  std::string security;
};

// Who wrote a message: the first octets of its participant's GUID. Where security is on they are a digest of its certificate's
// subject, which it has proved to bear (DDS Security 1.1, 9.3.3): nobody speaks in another's name. Else they say nothing.
using Sender = std::array<std::uint8_t, 6>;

// What a reader tells. Called on the vendor's threads (with Cyclone also inside the write() of a writer in this process), one at a
// time for one reader: copy or post, then return; never write to the bus, block, throw or destroy the reader inside.
struct ReaderEvents {
  // The bytes live until it returns. They may be any: whoever decodes them counts what is malformed.
  std::function<void(std::span<const std::byte> message)> on_message;
  // Instead of it, if set: with whoever wrote the message, or zeros if he is gone already.
  std::function<void(std::span<const std::byte> message, const Sender& sender)> on_message_from;
  std::function<void(std::size_t matched)> on_matched;   // writers matched now; optional
  std::function<void(std::size_t alive)> on_liveliness;  // writers alive now; optional
};

class Writer {
 public:
  // What is not acknowledged yet is lost: wait_acknowledged() first if that matters.
  virtual ~Writer() = default;
  enum class Result : std::uint8_t { kSent, kFull, kFailed };
  // Never blocks. kFull: as much is under way as may be (about 256 kB, or 256 messages) and some matched reader has not
  // acknowledged it yet: try again after a millisecond. A reader that acknowledges nothing, such as one that died without a word,
  // holds up the others only as far as that lasts: till 256 kB are unacknowledged (Cyclone) or `history` messages (Fast DDS, which
  // sends them in tenths of a second). A writer without readers is never full: it keeps the newest `history` messages. kFailed: the
  // bytes bear no XCDR1 encapsulation, are too short for the topic's key or longer than kMaxMessage, or the vendor gave an error
  // (last_error()). Any thread, one at a time.
  virtual Result write(std::span<const std::byte> message) = 0;
  virtual std::string last_error() const = 0;
  virtual std::size_t matched() const = 0;  // readers matched now
  virtual void assert_liveliness() = 0;     // of topics with manual liveliness
  // True if every matched reader has acknowledged all that was written, at the latest after `seconds`.
  virtual bool wait_acknowledged(double seconds) = 0;
};

class Reader {
 public:
  virtual ~Reader() = default;  // no callback runs after it returns
  virtual std::size_t matched() const = 0;
};

// Thread rule: any thread; entities must be destroyed before their bus. The destructor deletes every entity of the vendor.
class Bus {
 public:
  virtual ~Bus() = default;
  // `partition` empty: the default one; "*" in a reader: all. Throws BusError.
  virtual std::unique_ptr<Writer> writer(Topic topic, const std::string& partition) = 0;
  virtual std::unique_ptr<Reader> reader(Topic topic, const std::string& partition, ReaderEvents events) = 0;
  virtual std::string_view vendor() const = 0;
  virtual std::string version() const = 0;  // of the vendor's library
};

// Loads libfoothold_bus_<vendor>.so (beside the program's libraries, then by the loader's path) and opens it. Throws BusError.
std::unique_ptr<Bus> open_bus(const BusOptions& options);

// What a bus library exports, as `foothold_open_bus_1`.
using OpenBus = Bus* (*)(const BusOptions&);
#define FOOTHOLD_BUS_ENTRY extern "C" [[gnu::visibility("default")]] foothold::transport::Bus* foothold_open_bus_1

}  // namespace foothold::transport

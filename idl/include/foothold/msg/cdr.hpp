// From message to bytes and back: XCDR1, little endian, with the four octets of encapsulation in front, exactly as DDS carries it.
// The same bytes travel between server and workers and lie in the journal.
#pragma once

#include <fastcdr/Cdr.h>
#include <fastcdr/FastBuffer.h>
#include <fastcdr/exceptions/Exception.h>

#include <cstddef>
#include <optional>
#include <span>
#include <stdexcept>
#include <vector>

namespace foothold::msg {

using Bytes = std::vector<std::byte>;

// Keeps the first `prefix` octets of `out` (a frame's header; made if absent), and its capacity: the rest is exactly the message
// afterwards. Thread rule: none, works on its arguments only.
template <class Message>
void encode_into(const Message& message, Bytes& out, std::size_t prefix = 0) {
  // Alignment leaves octets unwritten: they must be the same in each encoding, not what the buffer held before.
  out.resize(prefix);
  // Encapsulation plus the payload; alignment is counted from behind the encapsulation.
  out.resize(prefix + 4 + Message::getCdrSerializedSize(message));
  eprosima::fastcdr::FastBuffer buffer(reinterpret_cast<char*>(out.data()) + prefix, out.size() - prefix);
  eprosima::fastcdr::Cdr cdr(buffer, eprosima::fastcdr::Cdr::LITTLE_ENDIANNESS, eprosima::fastcdr::Cdr::DDS_CDR);
  cdr.serialize_encapsulation();
  message.serialize(cdr);
  out.resize(prefix + cdr.getSerializedDataLength());
}

template <class Message>
Bytes encode(const Message& message) {
  Bytes out;
  encode_into(message, out);
  return out;
}

// Nothing if the bytes are not a whole message of this type: too short, a length beyond the end, no encapsulation. Never throws
// for any contents.
template <class Message>
std::optional<Message> decode(std::span<const std::byte> bytes) {
  try {
    // Fast CDR takes a mutable buffer and only reads it.
    eprosima::fastcdr::FastBuffer buffer(const_cast<char*>(reinterpret_cast<const char*>(bytes.data())), bytes.size());
    eprosima::fastcdr::Cdr cdr(buffer, eprosima::fastcdr::Cdr::DEFAULT_ENDIAN, eprosima::fastcdr::Cdr::DDS_CDR);
    cdr.read_encapsulation();
    Message message;
    message.deserialize(cdr);
    return message;
  } catch (const eprosima::fastcdr::exception::Exception&) {
    return std::nullopt;
  } catch (const std::bad_alloc&) {
    return std::nullopt;
  } catch (const std::length_error&) {
    return std::nullopt;
  }
}

}  // namespace foothold::msg

// Copies octets between Fast DDS's payloads and ours; a sample too short to bear its key is refused.
#include "bytes_type.hpp"

#include <fastrtps/utils/md5.h>

#include <string>

namespace foothold::transport::fastdds {

using eprosima::fastrtps::rtps::InstanceHandle_t;
using eprosima::fastrtps::rtps::SerializedPayload_t;

// Room that a payload gets at first; it grows with the message.
constexpr std::uint32_t kUsualSize = 512;

BytesType::BytesType(const TopicTraits& topic) : topic_(topic) {
  setName(std::string(topic.type).c_str());
  m_typeSize = kUsualSize;
  m_isGetKeyDefined = topic.keyed;
  auto_fill_type_object(false);
  auto_fill_type_information(false);
}

bool BytesType::serialize(void* data, SerializedPayload_t* payload) {
  const std::span<const std::byte> out = static_cast<const BytesSample*>(data)->out;
  if (out.size() < kEncapsulation || out.size() > payload->max_size) return false;
  std::memcpy(payload->data, out.data(), out.size());
  payload->length = static_cast<std::uint32_t>(out.size());
  payload->encapsulation = std::to_integer<std::uint16_t>(out[1]);
  return true;
}

bool BytesType::deserialize(SerializedPayload_t* payload, void* data) {
  const auto* octets = reinterpret_cast<const std::byte*>(payload->data);
  if (payload->length < kEncapsulation + (topic_.keyed ? sizeof(Key) : 0)) return false;
  static_cast<BytesSample*>(data)->in.assign(octets, octets + payload->length);
  return true;
}

std::function<std::uint32_t()> BytesType::getSerializedSizeProvider(void* data) {
  return [size = static_cast<std::uint32_t>(static_cast<const BytesSample*>(data)->out.size())] { return size; };
}

void* BytesType::createData() { return new BytesSample; }

void BytesType::deleteData(void* data) { delete static_cast<BytesSample*>(data); }

bool BytesType::getKey(void* data, InstanceHandle_t* handle, bool force_md5) {
  if (!topic_.keyed) return false;
  const auto& sample = *static_cast<const BytesSample*>(data);
  const std::span<const std::byte> message = sample.out.empty() ? std::span<const std::byte>(sample.in) : sample.out;
  if (message.size() < kEncapsulation + sizeof(Key)) return false;
  Key key = key_of(message);
  if (force_md5) {
    MD5 digest;
    digest.init();
    digest.update(key.data(), static_cast<unsigned>(key.size()));
    digest.finalize();
    std::memcpy(key.data(), digest.digest, key.size());
  }
  std::memcpy(&handle->value[0], key.data(), key.size());
  return true;
}

}  // namespace foothold::transport::fastdds

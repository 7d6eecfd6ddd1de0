// A topic type of Fast DDS whose samples are CDR octets as they are. The product needs no generated PubSubTypes.
#pragma once

#include <fastdds/dds/topic/TopicDataType.hpp>

#include <cstddef>
#include <span>
#include <vector>

#include "../encapsulation.hpp"

namespace foothold::transport::fastdds {

// What Fast DDS takes as the "data" of this type: a writer gives `out`, a reader gets `in`.
struct BytesSample {
  std::span<const std::byte> out;
  std::vector<std::byte> in;
};

class BytesType final : public eprosima::fastdds::dds::TopicDataType {
 public:
  explicit BytesType(const TopicTraits& topic);

  bool serialize(void* data, eprosima::fastrtps::rtps::SerializedPayload_t* payload) override;
  bool deserialize(eprosima::fastrtps::rtps::SerializedPayload_t* payload, void* data) override;
  std::function<std::uint32_t()> getSerializedSizeProvider(void* data) override;
  void* createData() override;
  void deleteData(void* data) override;
  bool getKey(void* data, eprosima::fastrtps::rtps::InstanceHandle_t* handle, bool force_md5) override;

 private:
  const TopicTraits& topic_;
};

}  // namespace foothold::transport::fastdds

// The bus on Cyclone DDS 0.10: one participant, a topic per row of the table, a publisher or subscriber per writer or reader (a
// partition belongs to them).
#pragma once

#include <array>
#include <mutex>
#include <optional>
#include <utility>

#include "bytes_type.hpp"
#include "domain.hpp"

namespace foothold::transport::cyclone {

// An entity of Cyclone, deleted with its children.
class Entity {
 public:
  Entity() = default;
  // Throws BusError if `handle` is an error.
  Entity(dds_entity_t handle, const std::string& what);
  Entity(Entity&& other) noexcept : handle_(std::exchange(other.handle_, 0)) {}
  Entity& operator=(Entity&& other) noexcept;
  ~Entity();
  dds_entity_t get() const { return handle_; }
  explicit operator bool() const { return handle_ > 0; }

 private:
  dds_entity_t handle_ = 0;
};

struct BytesTopic {
  Entity entity;
  const ddsi_sertype* type = nullptr;  // as Cyclone keeps it
};

class CycloneBus final : public Bus {
 public:
  explicit CycloneBus(const BusOptions& options);
  std::unique_ptr<Writer> writer(Topic topic, const std::string& partition) override;
  std::unique_ptr<Reader> reader(Topic topic, const std::string& partition, ReaderEvents events) override;
  std::string_view vendor() const override { return "cyclone"; }
  std::string version() const override;

 private:
  const BytesTopic& topic_of(Topic topic);

  std::optional<Domain> domain_;
  Entity participant_;
  std::mutex mutex_;  // of topics_
  std::array<BytesTopic, kTopicCount> topics_;
};

std::unique_ptr<Writer> make_writer(dds_entity_t participant, const BytesTopic& bytes_topic, const TopicTraits& topic,
                                    const std::string& partition);
std::unique_ptr<Reader> make_reader(dds_entity_t participant, const BytesTopic& bytes_topic, const TopicTraits& topic,
                                    const std::string& partition, ReaderEvents events);

}  // namespace foothold::transport::cyclone

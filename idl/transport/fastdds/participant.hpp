// A participant of Fast DDS: on 127.0.0.1 alone, or by the profile "foothold" of a file.
#pragma once

#include <fastdds/dds/domain/DomainParticipant.hpp>

#include "../loopback_guard.hpp"
#include "departures.hpp"
#include "foothold/transport/bus.hpp"

namespace foothold::transport::fastdds {

// Any thread. Throws BusError.
class Participant {
 public:
  explicit Participant(const BusOptions& options);
  ~Participant();  // with everything that it contains
  Participant(const Participant&) = delete;
  Participant& operator=(const Participant&) = delete;
  eprosima::fastdds::dds::DomainParticipant& operator*() const { return *participant_; }
  eprosima::fastdds::dds::DomainParticipant* operator->() const { return participant_; }

 private:
  void confine(const LoopbackGuard& guard);

  Departures departures_;
  eprosima::fastdds::dds::DomainParticipant* participant_;
};

}  // namespace foothold::transport::fastdds

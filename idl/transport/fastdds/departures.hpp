// Keeps Fast DDS 2.9 from ending the process when a participant leaves at the very moment at which its lease is looked at.
//
// PDP::check_remote_participant_liveliness, on the thread of timers, may wait for the lock of participants while another thread
// takes that very participant away, and then finds it cleared: an assertion, which Debian's library holds. On a starved machine
// that happens to a server whose clients come and go; anybody on the network can bring it about. Before the participant is cleared
// its departure is told, with a reference to what both threads share: said there that its lease is not to be looked at any more,
// the timer finds nothing to do. (Who takes the place of the cleared one sets that anew.)
#pragma once

#include <fastdds/rtps/builtin/data/ParticipantProxyData.h>
#include <fastdds/rtps/participant/ParticipantDiscoveryInfo.h>

#include <atomic>
#include <fastdds/dds/domain/DomainParticipantListener.hpp>

namespace foothold::transport::fastdds {

// Of one participant, which it outlives. Called on the vendor's threads.
class Departures final : public eprosima::fastdds::dds::DomainParticipantListener {
 public:
  void on_participant_discovery(eprosima::fastdds::dds::DomainParticipant*,
                                eprosima::fastrtps::rtps::ParticipantDiscoveryInfo&& what) override {
    using What = eprosima::fastrtps::rtps::ParticipantDiscoveryInfo;
    if (what.status != What::REMOVED_PARTICIPANT && what.status != What::DROPPED_PARTICIPANT) return;
    auto& gone = const_cast<eprosima::fastrtps::rtps::ParticipantProxyData&>(what.info);
    std::atomic_ref(gone.should_check_lease_duration).store(false);
  }
};

}  // namespace foothold::transport::fastdds

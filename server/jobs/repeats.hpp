// Steps that clients asked for, sent again a window at a time (idl/PROTOCOL.md P17): what is under way to a client already is not
// sent to it twice, however often it asks.
#pragma once

#include <cstdint>
#include <deque>
#include <unordered_map>

#include "jobs/ports.hpp"

namespace foothold::server {

class Repeats {
 public:
  static constexpr std::uint32_t kWindow = 256;  // steps at a time
  static constexpr std::size_t kMost = 1000;     // answers under way to one client; it asks again for more

  // The steps from `from` to before `end` are to be sent. False if nothing is begun: some of them are under way, in an answer or
  // because they wait for this client's reader.
  bool ask(const Id& request, const Id& client, std::uint32_t from, std::uint32_t end, const Outbox& outbox);
  // Sends the next window to each client whose reader keeps up; of several answers to one client each has its turn. Throws
  // JournalError; the answer that it met is given up then.
  void send(Journal& journal, Outbox& outbox);
  bool empty() const { return answers_.empty(); }

 private:
  struct Answer {
    Id request{};
    std::uint32_t next = 0, end = 0;
  };
  std::unordered_map<Id, std::deque<Answer>, msg::IdHash> answers_;  // by client
};

}  // namespace foothold::server

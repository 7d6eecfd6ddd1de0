// See audit.hpp.
#include "audit.hpp"

#include <algorithm>

#include "foothold/msg/cdr.hpp"
#include "journal/store.hpp"

namespace foothold::faults {
namespace {

class Auditor {
 public:
  Auditor(server::Store& store, Audit& audit) : store_(store), audit_(audit) {}

  // The chain of the steps, for the comparison with a client's.
  std::string look_at_steps(const msg::Id& id, std::uint32_t promised) {
    std::string chain;
    std::uint32_t index = 0;
    for (const msg::Bytes& octets : store_.steps(id, 0)) {
      const auto step = msg::decode<msg::Step>(octets);
      if (!step || step->request() != id || step->index() != index) {
        complain(id, "step " + std::to_string(index) + " of the journal is not that step");
        return chain;
      }
      for (const msg::Margin& margin : step->margins())
        if (!(margin.value() >= margin.least()))
          complain(id, "step " + std::to_string(index) + ": " + margin.name() + " below its least");
      extend_chain(chain, msg::encode(*step));
      ++index;
      ++audit_.steps;
    }
    if (index != promised) complain(id, "the journal holds " + std::to_string(index) + " steps of " + std::to_string(promised));
    return chain;
  }

  void complain(const msg::Id& id, const std::string& what) {
    constexpr std::size_t kMost = 100;
    if (audit_.complaints.size() < kMost) audit_.complaints.push_back(msg::to_hex(id) + ": " + what);
  }

 private:
  server::Store& store_;
  Audit& audit_;
};

}  // namespace

Audit audit(const std::string& journal, const std::map<msg::Id, Outcome>& noted, const std::map<msg::Id, Final>& heard,
            Judge& judge, std::size_t most_judged) {
  Audit out;
  server::Store store(journal);
  Auditor auditor(store, out);
  for (const server::Record& record : store.unfinished()) auditor.complain(record.request.id(), "has no final state");
  std::vector<msg::Id> ids;
  store.visit_ids([&](const msg::Id& id) { ids.push_back(id); });
  std::sort(ids.begin(), ids.end());
  std::map<msg::Id, Final> kept;
  for (const msg::Id& id : ids) {
    const auto record = store.find(id);
    if (!record || !record->final_event) continue;  // complained of
    ++out.requests;
    const msg::PlanEvent& event = *record->final_event;
    const Final end{event.state(), event.error().code(), event.steps()};
    kept.emplace(id, end);
    const std::string chain = auditor.look_at_steps(id, end.steps);
    // Ids are random, and so is which plans come first.
    if (out.judged < most_judged && end.steps > 0 && judge.knows(record->request.robot())) {
      if (const auto refusal = judge.refusal(record->request, store.steps(id, 0))) auditor.complain(id, *refusal);
      ++out.judged;
    }
    if (const auto note = noted.find(id); note != noted.end()) {
      if (Final{note->second.state, note->second.code, note->second.steps} != end)
        auditor.complain(id, "its client was told of state " + std::to_string(note->second.state) + ", error " +
                                 std::to_string(note->second.code) + ", " + std::to_string(note->second.steps) +
                                 " steps; the journal says state " + std::to_string(end.state) + ", error " +
                                 std::to_string(end.code) + ", " + std::to_string(end.steps) + " steps");
      else if (note->second.chain != chain)
        auditor.complain(id, "its client has other steps than the journal");
    }
    if (const auto told = heard.find(id); told != heard.end() && told->second != end)
      auditor.complain(
          id, "was told as state " + std::to_string(told->second.state) + ", the journal says " + std::to_string(end.state));
  }
  for (const auto& [id, note] : noted)
    if (!kept.contains(id))
      auditor.complain(id, "ended at its client as " + std::to_string(note.state) + ", but the journal does not know it");
  for (const auto& [id, end] : heard)
    if (!kept.contains(id)) auditor.complain(id, "was told to have ended, but the journal does not know it");
  return out;
}

}  // namespace foothold::faults

// The journal after the storm, held against what clients and observer heard.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "judge.hpp"
#include "observer.hpp"
#include "record.hpp"

namespace foothold::faults {

struct Audit {
  std::size_t requests = 0, steps = 0;  // that the journal holds
  std::size_t judged = 0;               // plans whose steps were judged once more
  std::vector<std::string> complaints;  // sentences, a hundred at most
};

// `journal`: the database of a server that has ended. Complains of a request without a final state, steps that are not numbered
// from 0 without gaps or are not as many as the final state says, a margin below its least, and of every difference between the
// journal and what a client noted or the observer heard; and of every plan among `most_judged` of the judge's robots that the judge
// refuses.
Audit audit(const std::string& journal, const std::map<msg::Id, Outcome>& noted, const std::map<msg::Id, Final>& heard,
            Judge& judge, std::size_t most_judged);

}  // namespace foothold::faults

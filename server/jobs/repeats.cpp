// One window after the other.
#include "jobs/repeats.hpp"

#include <algorithm>

namespace foothold::server {

bool Repeats::ask(const Id& request, const Id& client, std::uint32_t from, std::uint32_t end, const Outbox& outbox) {
  if (const auto under_way = answers_.find(client); under_way != answers_.end()) {
    auto& answers = under_way->second;
    if (const auto same = std::ranges::find(answers, request, &Answer::request); same != answers.end()) {
      same->next = std::max(same->next, from);  // what lies before it has arrived meanwhile
      same->end = std::max(same->end, end);
      return false;
    }
    if (answers.size() >= kMost) return false;
  }
  if (outbox.waits(client, request)) return false;
  answers_[client].push_back({request, from, end});
  return true;
}

void Repeats::send(Journal& journal, Outbox& outbox) {
  for (auto& [client, answers] : answers_) {
    if (answers.empty() || outbox.waits(client)) continue;
    Answer answer = answers.front();
    answers.pop_front();
    const auto steps = journal.steps(answer.request, answer.next, std::min(kWindow, answer.end - answer.next));
    for (const Bytes& step : steps) outbox.step(client, step);
    answer.next += static_cast<std::uint32_t>(steps.size());
    if (!steps.empty() && answer.next < answer.end) answers.push_back(answer);
  }
  std::erase_if(answers_, [](const auto& entry) { return entry.second.empty(); });
}

}  // namespace foothold::server

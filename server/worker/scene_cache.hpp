// Prepared scenes by what they depend on; the ones used last are kept.
#pragma once

#include <cstddef>
#include <list>
#include <memory>
#include <string>
#include <utility>

#include "foothold/planner.hpp"

namespace foothold::server {

// Thread rule: one thread.
class SceneCache {
 public:
  explicit SceneCache(std::size_t most) : most_(most) {}

  std::shared_ptr<const PreparedScene> find(const std::string& key) {
    for (auto entry = entries_.begin(); entry != entries_.end(); ++entry)
      if (entry->first == key) {
        entries_.splice(entries_.begin(), entries_, entry);
        return entry->second;
      }
    return nullptr;
  }

  void keep(std::string key, std::shared_ptr<const PreparedScene> scene) {
    if (entries_.size() == most_) entries_.pop_back();
    entries_.emplace_front(std::move(key), std::move(scene));
  }

 private:
  std::size_t most_;
  std::list<std::pair<std::string, std::shared_ptr<const PreparedScene>>> entries_;
};

}  // namespace foothold::server

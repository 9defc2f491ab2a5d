#include "storage/repository/current_grid_cache.hpp"

#include <algorithm>

namespace floeplan::repository {

std::shared_ptr<const ocean::CurrentGrid> CurrentGridCache::find(const Key& key) {
  const std::scoped_lock lock{mutex_};
  const auto found = std::ranges::find(entries_, key, &Entry::key);
  if (found == entries_.end()) return nullptr;
  entries_.splice(entries_.begin(), entries_, found);
  return found->grid;
}

void CurrentGridCache::keep(const Key& key, const std::shared_ptr<const ocean::CurrentGrid>& grid) {
  const auto& samples = grid->samples();
  const std::size_t bytes = (samples.u.size() + samples.v.size()) * sizeof(float);
  if (bytes > most_bytes_) return;
  std::list<Entry> dropped;  // freed after the lock
  const std::scoped_lock lock{mutex_};
  if (std::ranges::find(entries_, key, &Entry::key) != entries_.end()) return;
  while (bytes_ + bytes > most_bytes_) {
    bytes_ -= entries_.back().bytes;
    dropped.splice(dropped.end(), entries_, std::prev(entries_.end()));
  }
  entries_.push_front({key, grid, bytes});
  bytes_ += bytes;
}

}  // namespace floeplan::repository

#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <list>
#include <memory>
#include <mutex>

namespace floeplan::repository {

/// What took long to make, for others who want just the same.
/// Memory   at most so many bytes, by what whoever keeps a value says of it: those that were used last; a larger value
///          is not kept. Whoever uses a value keeps it alive beyond that
/// Threads  all members may be called from several threads at once
template <class Key, class Value>
class RecentlyUsed {
 public:
  explicit RecentlyUsed(std::size_t most_bytes) : most_bytes_{most_bytes} {}

  [[nodiscard]] std::size_t most_bytes() const { return most_bytes_; }

  /// Null where it is not kept.
  [[nodiscard]] std::shared_ptr<const Value> find(const Key& key) {
    const std::scoped_lock lock{mutex_};
    const auto found = std::ranges::find(entries_, key, &Entry::key);
    if (found == entries_.end()) return nullptr;
    entries_.splice(entries_.begin(), entries_, found);
    return found->value;
  }

  void keep(const Key& key, const std::shared_ptr<const Value>& value, std::size_t bytes) {
    if (bytes > most_bytes_) return;
    std::list<Entry> dropped;  // freed after the lock
    const std::scoped_lock lock{mutex_};
    if (std::ranges::find(entries_, key, &Entry::key) != entries_.end()) return;
    while (bytes_ + bytes > most_bytes_) {
      bytes_ -= entries_.back().bytes;
      dropped.splice(dropped.end(), entries_, std::prev(entries_.end()));
    }
    entries_.push_front({key, value, bytes});
    bytes_ += bytes;
  }

 private:
  struct Entry {
    Key key;
    std::shared_ptr<const Value> value;
    std::size_t bytes{};
  };

  std::size_t most_bytes_;
  std::mutex mutex_;
  std::list<Entry> entries_;  // the one used last first
  std::size_t bytes_{};
};

}  // namespace floeplan::repository

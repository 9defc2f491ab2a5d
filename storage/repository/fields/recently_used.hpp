#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <list>
#include <memory>
#include <mutex>

namespace floeplan::repository {

/// A cache of values that take long to make.
/// Memory   at most `most_bytes`, by the sizes that callers state: the values used last. A larger value is
///          not kept. A caller that still uses a value keeps it alive after it was dropped
/// Threads  all members may be called from several threads at once
template <class Key, class Value>
class RecentlyUsed {
 public:
  explicit RecentlyUsed(std::size_t most_bytes) : most_bytes_{most_bytes} {}

  [[nodiscard]] std::size_t most_bytes() const { return most_bytes_; }

  /// The cached value; null if there is none.
  [[nodiscard]] std::shared_ptr<const Value> find(const Key& key) {
    const std::scoped_lock lock{mutex_};
    const auto found = std::ranges::find(entries_, key, &Entry::key);
    if (found == entries_.end()) return nullptr;
    entries_.splice(entries_.begin(), entries_, found);
    return found->value;
  }

  void keep(const Key& key, const std::shared_ptr<const Value>& value, std::size_t bytes) {
    if (bytes > most_bytes_) return;
    std::list<Entry> dropped;  // destroyed after the lock is released
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
  std::list<Entry> entries_;  // most recently used first
  std::size_t bytes_{};
};

}  // namespace floeplan::repository

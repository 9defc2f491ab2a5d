#include "api/routes/guess_guard.hpp"

#include <algorithm>

namespace floeplan::routes {

/// With the time that has passed already forgiven.
GuessGuard::Record& GuessGuard::record_of(const std::string& address, core::UtcTime now) {
  if (records_.size() >= most_addresses && !records_.contains(address)) {
    records_.erase(std::min_element(records_.begin(), records_.end(), [](const auto& a, const auto& b) {
      return a.second.as_of < b.second.as_of;
    }));
  }
  Record& record = records_.try_emplace(address, Record{0.0, now, {}}).first->second;
  const double forgiven = std::max((now - record.as_of) / interval, 0.0);  // a clock may be set back
  record.wrong = std::max(record.wrong - forgiven, 0.0);
  record.as_of = now;
  return record;
}

core::Seconds GuessGuard::wait(const std::string& address, const std::string& digest, core::UtcTime now) {
  const std::lock_guard lock{mutex_};
  if (!records_.contains(address)) return core::Seconds{0.0};
  const Record& record = record_of(address, now);
  if (record.proven.contains(digest)) return core::Seconds{0.0};
  return std::max(record.wrong + 1.0 - burst, 0.0) * interval;
}

void GuessGuard::note_wrong(const std::string& address, core::UtcTime now) {
  const std::lock_guard lock{mutex_};
  record_of(address, now).wrong += 1.0;
}

void GuessGuard::note_right(const std::string& address, const std::string& digest, core::UtcTime now) {
  const std::lock_guard lock{mutex_};
  Record& record = record_of(address, now);
  if (record.proven.size() >= most_proven) record.proven.clear();
  record.proven.insert(digest);
}

}  // namespace floeplan::routes

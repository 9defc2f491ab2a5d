#include "api/routes/access/guess_guard.hpp"

#include <algorithm>

namespace floeplan::routes {

double RateLimit::done_by(const Record& record, core::UtcTime now) const {
  // the clock may have been set back
  const double forgiven = std::max((now - record.as_of) / interval_, 0.0);
  return std::max(record.done - forgiven, 0.0);
}

core::Seconds RateLimit::wait(const std::string& who, core::UtcTime now) const {
  const auto found = records_.find(who);
  if (found == records_.end()) return core::Seconds{0.0};
  return std::max(done_by(found->second, now) + 1.0 - burst_, 0.0) * interval_;
}

void RateLimit::note(const std::string& who, core::UtcTime now) {
  if (records_.size() >= most_known && !records_.contains(who)) {
    records_.erase(std::min_element(records_.begin(), records_.end(), [](const auto& a, const auto& b) {
      return a.second.as_of < b.second.as_of;
    }));
  }
  Record& record = records_.try_emplace(who, Record{0.0, now}).first->second;
  record = {done_by(record, now) + 1.0, now};
}

core::Seconds GuessGuard::wait(const Shown& shown, core::UtcTime now) {
  const std::lock_guard lock{mutex_};
  const auto proven = proven_.find(shown.address);
  if (proven != proven_.end() && proven->second.contains(shown.digest)) return core::Seconds{0.0};
  const core::Seconds of_address = wrong_from_.wait(shown.address, now);
  return shown.key.empty() ? of_address : std::max(of_address, wrong_of_.wait(shown.key, now));
}

void GuessGuard::note_wrong(const Shown& shown, core::UtcTime now) {
  const std::lock_guard lock{mutex_};
  wrong_from_.note(shown.address, now);
  if (!shown.key.empty()) wrong_of_.note(shown.key, now);
}

void GuessGuard::note_right(const Shown& shown, core::UtcTime) {
  const std::lock_guard lock{mutex_};
  if (proven_.size() >= most_addresses && !proven_.contains(shown.address)) proven_.clear();
  std::set<std::string>& proven = proven_[shown.address];
  if (proven.size() >= most_proven) proven.clear();
  proven.insert(shown.digest);
}

core::Seconds GuessGuard::wait_to_log_in(const Shown& shown, core::UtcTime now) {
  const std::lock_guard lock{mutex_};
  const core::Seconds wait = std::max(logins_from_.wait(shown.address, now), logins_of_.wait(shown.key, now));
  if (wait > core::Seconds{0.0}) return wait;
  logins_from_.note(shown.address, now);
  logins_of_.note(shown.key, now);
  return wait;
}

}  // namespace floeplan::routes

#include "api/routes/access/guess_guard.hpp"

#include <algorithm>

namespace floeplan::routes {

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

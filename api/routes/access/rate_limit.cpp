#include "api/routes/access/rate_limit.hpp"

#include <algorithm>

namespace floeplan::routes {

double RateLimit::done_by(const Record& record, core::UtcTime now) const {
  const double forgiven = std::max((now - record.as_of) / interval_, 0.0);  // a clock may be set back
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

}  // namespace floeplan::routes

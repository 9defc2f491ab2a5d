#include "engine/planning/problem/time_span.hpp"

#include <algorithm>

namespace floeplan::planning {

std::vector<TimeSpan> joined(std::vector<TimeSpan> spans) {
  std::ranges::sort(spans, {}, &TimeSpan::from);
  std::vector<TimeSpan> result;
  for (const TimeSpan& span : spans) {
    if (result.empty() || span.from > result.back().until) {
      result.push_back(span);
    } else {
      result.back().until = std::max(result.back().until, span.until);
    }
  }
  return result;
}

core::Seconds open_from(const std::vector<TimeSpan>& closed, core::Seconds when) {
  for (const TimeSpan& span : closed)
    if (span.from <= when && when < span.until) when = span.until;
  return when;
}

}  // namespace floeplan::planning

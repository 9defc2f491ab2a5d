#pragma once

#include <vector>

#include "engine/core/units.hpp"

namespace floeplan::planning {

/// A length of time with both ends, counted from the epoch of its user.
struct TimeSpan {
  core::Seconds from;
  core::Seconds until;
};

/// The times that lie in any of the spans: ascending, apart from each other.
[[nodiscard]] std::vector<TimeSpan> joined(std::vector<TimeSpan> spans);

}  // namespace floeplan::planning

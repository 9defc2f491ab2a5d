#pragma once

#include <vector>

#include "engine/core/units.hpp"

namespace floeplan::planning {

/// A period that includes both its ends. Times are counted from an epoch that the caller chooses.
struct TimeSpan {
  core::Seconds from;
  core::Seconds until;
};

/// The union of the spans, as spans in ascending order that do not touch.
[[nodiscard]] std::vector<TimeSpan> joined(std::vector<TimeSpan> spans);

/// The first time, from `when` on, at which a place is open. Infinite: there is none.
/// `closed`  the times at which it is not, ascending
[[nodiscard]] core::Seconds open_from(const std::vector<TimeSpan>& closed, core::Seconds when);

}  // namespace floeplan::planning

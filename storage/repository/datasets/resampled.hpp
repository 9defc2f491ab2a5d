#pragma once

#include <algorithm>
#include <span>
#include <string>

namespace floeplan::repository {

/// Whether currents, wind, depths or sea ice were resampled when an older version ingested them, or brought from the points
/// of each component to the centres between them, which it said among its warnings. The same file, ingested again, makes
/// a dataset at its model's own points.
[[nodiscard]] inline bool was_resampled(std::span<const std::string> warnings) {
  return std::ranges::any_of(warnings, [](const std::string& warning) {
    return warning.starts_with("resampled from ") ||
           warning.find("was resampled from a bent grid of") != std::string::npos ||
           warning.starts_with("the grid was resampled from ") ||
           warning.find("points (a bent and staggered grid)") != std::string::npos;
  });
}

}  // namespace floeplan::repository

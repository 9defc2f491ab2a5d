#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/units.hpp"

namespace floeplan::planning {

/// Why refinement ended.
enum class RefinementEnd {
  converged,    // nothing more to gain
  evaluations,  // as many legs timed as allowed: the same on every machine
  time,         // the caller's clock
  cancelled
};

[[nodiscard]] std::string refinement_end_name(RefinementEnd end);
[[nodiscard]] std::optional<RefinementEnd> parse_refinement_end(std::string_view name);

/// The least travel time that was found with so many legs.
struct LegTrade {
  std::size_t legs{};
  core::Seconds travel_time{};

  friend bool operator==(const LegTrade&, const LegTrade&) = default;
};

/// What moving the waypoints off the grid did.
struct RefinementReport {
  core::Seconds before{};  // travel time of the way of the grid
  core::Seconds
      after{};  // of the plan: more where few waypoints are allowed, or where it is not time that counts
  std::optional<core::Joules> energy_before{};  // where energy counts: drawn along the way of the grid
  std::optional<core::Joules> energy_after{};
  std::int64_t evaluations{};  // of a leg
  RefinementEnd end{};
  std::vector<LegTrade>
      trade{};  // what more legs are worth: few legs first, each entry faster than the last; only where time alone counts
};

}  // namespace floeplan::planning

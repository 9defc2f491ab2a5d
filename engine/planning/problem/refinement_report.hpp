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
  converged,    // no move of a waypoint gains anything
  evaluations,  // the limit on timed legs was reached; the same on every machine
  time,         // the clock ran past the limit; only of plans before 0.2
  cancelled
};

[[nodiscard]] std::string refinement_end_name(RefinementEnd end);
[[nodiscard]] std::optional<RefinementEnd> parse_refinement_end(std::string_view name);

/// The least travel time that was found with this number of legs.
struct LegTrade {
  std::size_t legs{};
  core::Seconds travel_time{};

  friend bool operator==(const LegTrade&, const LegTrade&) = default;
};

/// The result of moving the waypoints off the grid.
struct RefinementReport {
  core::Seconds before{};  // travel time of the route on the grid
  core::Seconds
      after{};  // travel time of the plan; may be longer where few waypoints are allowed or time is not the objective
  std::optional<core::Joules>
      energy_before{};  // drawn on the route on the grid; only where energy is in the objective
  std::optional<core::Joules> energy_after{};
  std::int64_t evaluations{};  // how many times a leg was timed
  RefinementEnd end{};
  std::vector<LegTrade>
      trade{};  // for the objective time: the gain of more legs, each entry with more legs and faster than the last
};

}  // namespace floeplan::planning

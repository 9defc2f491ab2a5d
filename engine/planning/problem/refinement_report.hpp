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
  converged,    // no move of a waypoint reduces the cost
  evaluations,  // the limit on timed legs was reached: the same result on every machine
  time,         // the time limit was reached; only in plans of versions before 0.2
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

/// The result of refinement, which moves the waypoints off the grid.
struct RefinementReport {
  core::Seconds before{};  // travel time of the route on the grid
  core::Seconds
      after{};  // of the plan; may be longer if few waypoints are allowed or time is not the objective
  std::optional<core::Joules>
      energy_before{};  // of the route on the grid; only if energy is in the objective
  std::optional<core::Joules> energy_after{};
  std::int64_t evaluations{};  // number of timed legs
  RefinementEnd end{};
  std::vector<LegTrade>
      trade{};  // what more legs gain, for the objective time; each entry has more legs and is faster
};

}  // namespace floeplan::planning

#pragma once

#include <cstddef>
#include <vector>

#include "engine/core/violation.hpp"
#include "engine/planning/plan.hpp"

namespace floeplan::mission {

/// The rows of one goto list: waypoints of the plan, the first and the last one.
struct ListPart {
  std::size_t first{};
  std::size_t last{};

  friend bool operator==(const ListPart&, const ListPart&) = default;
};

/// The plan's waypoints after the start in lists of at most `max_waypoints` rows, each as long as it can be and still end
/// where the vehicle may surface: there the list is flown, and the mission brings the vehicle up. Where no such waypoint
/// is within reach a list ends where nothing is known of the ice, and below it only where list_end_violations says so.
/// Precondition  `max_waypoints` is 1 or more
[[nodiscard]] std::vector<ListPart> part_into_lists(const planning::Plan& plan, std::size_t max_waypoints);

/// Where the plan cannot be parted so: more waypoints in a row below ice or icebergs than a list holds beside its end, and
/// an end of the plan below them.
[[nodiscard]] core::Violations list_end_violations(const planning::Plan& plan, std::size_t max_waypoints);

}  // namespace floeplan::mission

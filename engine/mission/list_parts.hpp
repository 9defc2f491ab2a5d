#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/core/violation.hpp"
#include "engine/planning/plan.hpp"

namespace floeplan::mission {

/// The rows of one goto list: waypoints of the plan, the first and the last one.
struct ListPart {
  std::size_t first{};
  std::size_t last{};

  friend bool operator==(const ListPart&, const ListPart&) = default;
};

struct ListRules {
  std::size_t max_waypoints{8};  // 1 or more rows
  core::Metres radius{10.0};     // in which a waypoint counts as reached
};

/// Whether ice or an iceberg is above somewhere on the way of the list.
[[nodiscard]] bool passes_below(const planning::Plan& plan, const ListPart& part);

/// How far from ice and icebergs a list ends whose way passes below them. The vehicle comes up as soon as it takes itself
/// to be within the radius of the last row, which it may be before it, by the radius and by its error of position.
struct ListEnd {
  core::Metres open_before;  // SurfacingState::open_before
  core::Metres error;        // grown on the way of the list, on which there is no fix

  [[nodiscard]] core::Metres room() const { return open_before - error; }  // for the radius
};

/// Empty where the list's way passes below nothing, and in plans stored before it was kept.
[[nodiscard]] std::optional<ListEnd> end_of(const planning::Plan& plan, const ListPart& part);

/// The plan's waypoints after the start in lists of at most `max_waypoints` rows, each as long as it can be and still end
/// where the vehicle may surface, farther from ice and icebergs than it may be off: there the list is flown, and the
/// mission brings the vehicle up. Where no such waypoint is within reach a list ends where nothing is known of the ice,
/// then where the vehicle may surface just there, and below the ice only where list_end_violations says so.
[[nodiscard]] std::vector<ListPart> part_into_lists(const planning::Plan& plan, const ListRules& rules);

/// Where the plan cannot be parted so: more waypoints in a row below ice or icebergs than a list holds beside its end, an
/// end of the plan below them, and an end of a list that is no farther from them than the vehicle may be off.
[[nodiscard]] core::Violations list_end_violations(const planning::Plan& plan, const ListRules& rules);

}  // namespace floeplan::mission

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/core/violation.hpp"
#include "engine/planning/problem/plan.hpp"

namespace floeplan::mission {

/// The rows of one goto list: first and last waypoint of the plan in it.
struct ListPart {
  std::size_t first{};
  std::size_t last{};
  std::size_t before{};  // first row of the list before it, 0: there is none
  /// How often the vehicle surfaces for a fix on the way; empty: only where the list ends.
  std::optional<core::Seconds> between_fixes{};

  friend bool operator==(const ListPart&, const ListPart&) = default;
};

struct ListRules {
  std::size_t max_waypoints{8};                  // 1 or more rows
  core::Metres radius{10.0};                     // in which a waypoint counts as reached
  std::optional<core::Seconds> between_fixes{};  // on the way of a list; empty: none
};

/// Whether ice or an iceberg is above somewhere on the list's route.
[[nodiscard]] bool passes_below(const planning::Plan& plan, const ListPart& part);

/// Distance of a list's end from ice and icebergs, if its route passes below them or ends near ice. The
/// vehicle surfaces when it believes to be within the radius of the last row, possibly before the row. The
/// position error reduces the distance to ice further. For an iceberg its disc already contains the
/// uncertainty, and an error of the vehicle is as likely to increase the distance.
struct ListEnd {
  std::optional<core::Metres> beyond_ice{};      // along the route; empty: it passes below no ice
  std::optional<core::Metres> beyond_iceberg{};  // along the route; empty: it passes below no iceberg
  /// In any direction; empty: farther than any error, unknown, or the plan was stored by an older version.
  std::optional<core::Metres> from_ice{};
  core::Metres error{};  // position error at the end of the list: error_of

  /// Distance from ice and icebergs, along the route, that is left for the radius of the last row if the
  /// vehicle is exactly on its route. Infinite if the route passes below none.
  [[nodiscard]] core::Metres room() const;
  [[nodiscard]] core::Metres sure_room() const;  // room that remains with the position error; may be negative
};

/// Position error at the end of a list. It grows since the last fix, and by the distance that the currents of
/// the plan carry the vehicle relative to the current with which it navigates. The last fix is at the start of
/// the list, or `between_fixes` before its end. The vehicle navigates with the mean current over the time between
/// the two previous fixes; if the list before had no other fix, with the mean current over that list; on the
/// first list, with none. Against currents unknown to the vehicle, the time under way is the time by its own
/// reckoning, if that is longer. Zero for plans that do not state their error.
[[nodiscard]] core::Metres error_of(const planning::Plan& plan, const ListPart& part);

/// Delay of the vehicle on the list, because the currents with which it navigates differ from the currents that
/// it meets. With `between_fixes` the delay until the first fix. The ice at the end of the list is judged only
/// for the planned time.
[[nodiscard]] core::Seconds late_by(const planning::Plan& plan, const ListPart& part);

/// Empty if the list's route passes below nothing and no ice is near its end, and for plans of older
/// versions.
[[nodiscard]] std::optional<ListEnd> end_of(const planning::Plan& plan, const ListPart& part);

/// Text such as "45 m beyond the ice (waypoint radius 500 m, position error 1.6 km)".
[[nodiscard]] std::string text_of(const ListEnd& end, core::Metres radius);

/// A distance for advice of "more than", rounded up to what `core::distance_text` shows of it.
[[nodiscard]] core::Metres told_upwards(core::Metres least);

/// Divides the plan's waypoints after the start into lists of at most `max_waypoints` rows. Each is as long
/// as possible but ends where the vehicle may surface, because the mission surfaces it there. The end is
/// farther from ice and icebergs than the position error if there is such a waypoint; otherwise farther than
/// the radius; otherwise where the ice is unknown. It is nearer or below them only in the cases of
/// list_end_violations. A list also ends at a hold where the vehicle may surface.
[[nodiscard]] std::vector<ListPart> part_into_lists(const planning::Plan& plan, const ListRules& rules);

/// The violations if the plan cannot be divided in this way: more consecutive waypoints below ice or icebergs
/// than a list holds, an end of the plan below them, or an end of a list within the radius of them.
[[nodiscard]] core::Violations list_end_violations(const planning::Plan& plan, const ListRules& rules);

}  // namespace floeplan::mission

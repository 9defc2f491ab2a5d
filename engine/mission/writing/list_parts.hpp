#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/core/violation.hpp"
#include "engine/planning/problem/plan.hpp"

namespace floeplan::mission {

/// The rows of one goto list: waypoints of the plan, the first and the last one.
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

/// Whether ice or an iceberg is above somewhere on the way of the list.
[[nodiscard]] bool passes_below(const planning::Plan& plan, const ListPart& part);

/// How far from ice and icebergs a list ends whose way passes below them or that ends near ice. The vehicle comes up as
/// soon as it takes itself to be within the radius of the last row, which it may be before it. Of ice, which lies
/// there, its error of position may take as much again; what is uncertain of an iceberg is in its disc, and where the
/// vehicle is off its way it is as likely to be farther from it.
struct ListEnd {
  std::optional<core::Metres> beyond_ice{};      // along the way; empty: the way passes below none
  std::optional<core::Metres> beyond_iceberg{};  // the same
  /// To any side; empty: it is farther than any error, nothing is known of it, or the plan is older than this.
  std::optional<core::Metres> from_ice{};
  core::Metres error{};  // of the list, as error_of tells

  /// For the radius, of a vehicle that knows where it is and comes along its way.
  [[nodiscard]] core::Metres room() const;
  [[nodiscard]] core::Metres sure_room() const;  // the same, however far it is off; may be negative
};

/// Position error where a list ends: the growth since the last fix, and how far the currents of the plan carry the vehicle
/// against the one that it navigates with. The last fix is that of the list's start, or `between_fixes` before the end. The
/// vehicle navigates with the mean current over the time between the two fixes before, with that over the list before where
/// there was no other fix, and with none on the first list. Against currents that it does not know of it is as long under way as
/// it takes by its own reckoning, if that is longer. Zero for plans that do not tell of their error.
[[nodiscard]] core::Metres error_of(const planning::Plan& plan, const ListPart& part);

/// How much longer than planned the vehicle is under way on the list, because it navigates with currents that it does not
/// meet there; with `between_fixes` until the first fix. The ice at its end is judged for the planned time alone.
[[nodiscard]] core::Seconds late_by(const planning::Plan& plan, const ListPart& part);

/// Empty where the list's way passes below nothing and no ice is near its end, and in plans stored before it was kept.
[[nodiscard]] std::optional<ListEnd> end_of(const planning::Plan& plan, const ListPart& part);

/// "45 m beyond the ice (waypoint radius 500 m, position error 1650 m)"
[[nodiscard]] std::string text_of(const ListEnd& end, core::Metres radius);

/// The plan's waypoints after the start in lists of at most `max_waypoints` rows, each as long as it can be and still
/// end where the vehicle may surface: there the list is flown, and the mission brings the vehicle up. Farther from ice
/// and icebergs than it may be off where such a waypoint is within reach, else farther than the radius; else where
/// nothing is known of the ice, and nearer to it or below it only where list_end_violations says so. Where the vehicle
/// holds and may come up, a list ends, too.
[[nodiscard]] std::vector<ListPart> part_into_lists(const planning::Plan& plan, const ListRules& rules);

/// Where the plan cannot be parted so: more waypoints in a row below ice or icebergs than a list holds beside its end,
/// an end of the plan below them, and an end of a list within the radius of them.
[[nodiscard]] core::Violations list_end_violations(const planning::Plan& plan, const ListRules& rules);

}  // namespace floeplan::mission

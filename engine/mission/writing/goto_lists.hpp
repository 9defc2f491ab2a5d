#pragma once

#include <optional>
#include <tl/expected.hpp>

#include "engine/core/units.hpp"
#include "engine/core/violation.hpp"
#include "engine/mission/writing/file_origin.hpp"
#include "engine/mission/writing/hold_lists.hpp"
#include "engine/mission/writing/mission_file.hpp"
#include "engine/planning/problem/plan.hpp"

namespace floeplan::mission {

/// Largest number for our lists: the firmware writes goto_l99, and its recovery under ice uses goto_l98.
inline constexpr int last_free_number = 97;

/// Options for writing a plan as lists. Values that are not in the plan are stated in the comments of each
/// file.
struct GotoListOptions {
  int first_number{10};                  // NN of the first goto_lNN.ma, 0 to 97
  int max_waypoints{8};                  // of one list: GliderProfile::max_waypoints_per_list
  std::optional<core::Metres> radius{};  // in which a waypoint is reached; default: see write_goto_lists
  int initial_waypoint{0};  // of the first list: its row from 0, -1 after the last achieved, -2 the closest
  bool may_end_below_ice{false};  // of lists that no vehicle flies
  /// How often the mission surfaces for a fix on the way of a list; empty: only where a list ends, as below ice.
  std::optional<core::Seconds> between_fixes{};
  bool thruster_in_yo{false};  // the yo that they are flown with turns it on for every leg
  HoldOptions holds{};
  FileOrigin origin{};
};

/// Default radius within which a waypoint counts as reached: the largest whole number of metres below half of
/// the shortest leg, from 10 to 500 m, so that no waypoint is skipped.
/// Precondition  two waypoints or more
[[nodiscard]] core::Metres default_waypoint_radius(const planning::Plan& plan);

/// The longest duration of one of the lists of write_goto_lists: below ice there is no contact before a list
/// ends.
/// Precondition  the options have no violations
[[nodiscard]] core::Seconds longest_list_time(const planning::Plan& plan, const GotoListOptions& options);

/// Writes the plan as GliderDOS goto lists (`goto_lNN.ma`), each to be flown once, from first row to last.
/// Start    left out, because the vehicle is already there. If the start were the first row, a vehicle that has
///          drifted since the plan was made would turn back to it
/// Length   at most `max_waypoints` rows. Longer plans continue in lists with consecutive numbers, and a warning
///          says that the pilot must send them one after the other. The firmware owns the numbers 98 and 99
/// Ends     The vehicle surfaces at the end of a list. So a list ends where the plan allows surfacing or, with a
///          warning, where the ice is unknown. Unless `may_end_below_ice`, it never ends below ice or an iceberg,
///          nor within the waypoint radius of them. A list that ends near them gets a smaller radius than usual. A
///          warning says if its position error may still bring it up below ice. This error grows from the start of
///          the list, or from the last of its fixes `between_fixes`
/// Holds    A list ends at a hold of ten minutes or more where the vehicle may surface. The next list has two rows
///          and keeps the vehicle near the place (hold_legs). A warning says when to send the list after it. If no
///          list of two rows is as short as the hold, there is only the warning
/// Errors   every violation at once: a place beyond 89 degrees of latitude, fewer than two waypoints, more
///          consecutive waypoints below ice or icebergs than a list holds, a plan or a list that ends below
///          them or too near to them, options out of range
/// Threads  may be called from several threads at once
[[nodiscard]] tl::expected<MissionFiles, core::Violations> write_goto_lists(const planning::Plan& plan,
                                                                            const GotoListOptions& options);

}  // namespace floeplan::mission

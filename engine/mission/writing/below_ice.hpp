#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/messages/message.hpp"
#include "engine/planning/problem/plan.hpp"

namespace floeplan::mission {

/// The depth above which no dive of the plan may turn: the deepest upper turn that ice or icebergs demand on
/// any leg, because a yo is the same everywhere. Zero if nothing is above.
[[nodiscard]] core::Metres least_upper_turn(const planning::Plan& plan);

/// Deepest draft of the ice and icebergs that the plan passes below. Never too small. Possibly too large if
/// one leg passes below ice and an iceberg, because the plan stores only the deeper turn of both. Zero in
/// open water.
/// `margin_below_ice`  distance that the plan's turns keep below the keels of ice
[[nodiscard]] core::Metres deepest_keel(const planning::Plan& plan, core::Metres margin_below_ice);

/// The ice above the vehicle at a waypoint.
enum class Overhead {
  open,     // it may surface
  unknown,  // no ice data: it passes as in open water, but surfacing is not counted on
  closed    // ice too dense to surface in, or an iceberg
};

/// Precondition  the plan has this waypoint
[[nodiscard]] Overhead overhead(const planning::Plan& plan, std::size_t waypoint);

/// Whether the vehicle may surface everywhere on the plan's route. Gaps in the data on ice forbid it. A plan made
/// without any data on ice counts as one in open water.
[[nodiscard]] bool may_surface_everywhere(const planning::Plan& plan);

/// Whether the plan states the upper turn of every leg. A plan that an older version stored, and that passes
/// where the vehicle may not surface, does not state it.
[[nodiscard]] bool tells_upper_turns(const planning::Plan& plan);

/// Texts about ice that has moved over the route since the plan was made: ice or icebergs deeper than the upper
/// turns of its dives, and waypoints where the vehicle may no longer surface. `now`: the same route with the
/// newest data.
[[nodiscard]] std::vector<std::string> closed_above_since(const planning::Plan& plan,
                                                          const planning::Plan& now);

/// Warnings for the pilot: where the plan passes below ice, where the ice above is unknown, and where there
/// is no place to surface.
[[nodiscard]] std::vector<messages::Message> warnings_below_ice(const planning::Plan& plan);

}  // namespace floeplan::mission

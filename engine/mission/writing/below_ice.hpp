#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/messages/message.hpp"
#include "engine/planning/problem/plan.hpp"

namespace floeplan::mission {

/// The depth above which no dive of the plan may turn, because a yo knows no places: the deepest that ice or icebergs
/// ask for anywhere on its legs. Zero where nothing is above.
[[nodiscard]] core::Metres least_upper_turn(const planning::Plan& plan);

/// Deepest draft of the ice and the icebergs that the plan passes below. It is never too small. It may be too large where
/// one leg passes below ice and an iceberg, because the plan keeps only the deeper turn of both. Zero in open water.
/// `margin_below_ice`  that the plan's turns keep below the keels of ice
[[nodiscard]] core::Metres deepest_keel(const planning::Plan& plan, core::Metres margin_below_ice);

/// What is above a waypoint when the vehicle is there.
enum class Overhead {
  open,     // it may surface
  unknown,  // nothing is known of the ice: it passes as in open water, and does not count on surfacing
  closed    // ice too dense to surface in, or an iceberg
};

/// Precondition  the plan has such a waypoint
[[nodiscard]] Overhead overhead(const planning::Plan& plan, std::size_t waypoint);

/// Whether the vehicle may surface everywhere on the plan's route. Ice that nobody knows in the midst of known ice forbids it; a
/// plan made without data on ice is one in open water.
[[nodiscard]] bool may_surface_everywhere(const planning::Plan& plan);

/// Whether the plan says of every leg how deep its dives turn. One stored by an older version, which passes where the
/// vehicle may not surface, does not.
[[nodiscard]] bool tells_upper_turns(const planning::Plan& plan);

/// What has come to lie above a plan since it was made: deeper ice or icebergs than its dives turn below, and waypoints
/// where the vehicle may not surface any more. `now`: the same way in the newest data.
[[nodiscard]] std::vector<std::string> closed_above_since(const planning::Plan& plan,
                                                          const planning::Plan& now);

/// Where the plan passes below ice, where it passes below what is not known, and where there is nowhere to surface, for
/// the pilot.
[[nodiscard]] std::vector<messages::Message> warnings_below_ice(const planning::Plan& plan);

}  // namespace floeplan::mission

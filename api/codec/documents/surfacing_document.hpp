#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "engine/planning/problem/surfacing_plan.hpp"

namespace floeplan::codec {

/// Adds to a waypoint's object what ice means there; null where nothing is known of ice and nothing was asked for.
void add_surfacing_state(const std::optional<planning::SurfacingPlan>& plan, std::size_t waypoint,
                         nlohmann::json& object);
/// The planned surfacings and escapes of a plan; null as above.
[[nodiscard]] nlohmann::json surfacing_json(const std::optional<planning::SurfacingPlan>& plan);

/// Whether dives on the leg that leads to a waypoint must turn below sea ice or icebergs somewhere; false also where nothing
/// is known of ice.
[[nodiscard]] bool is_leg_below_ice(const std::optional<planning::SurfacingPlan>& plan, std::size_t waypoint);

/// The reverse of both, for the document of a stored plan.
/// Errors   nlohmann::json::exception when a member is missing or of another type; std::runtime_error for a time that
///          is none
[[nodiscard]] std::optional<planning::SurfacingPlan> parse_surfacing(const nlohmann::json& document);

}  // namespace floeplan::codec

#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "engine/planning/problem/surfacing_plan.hpp"

namespace floeplan::codec {

/// Adds to the object of a waypoint what the ice there allows; null if no ice is known and no surfacing rule
/// was given.
void add_surfacing_state(const std::optional<planning::SurfacingPlan>& plan, std::size_t waypoint,
                         nlohmann::json& object);
/// The planned surfacings and escapes of a plan; null if no ice is known and no surfacing rule was given.
[[nodiscard]] nlohmann::json surfacing_json(const std::optional<planning::SurfacingPlan>& plan);

/// Whether dives on the leg to a waypoint must turn below sea ice or icebergs somewhere; false also if no ice
/// is known.
[[nodiscard]] bool is_leg_below_ice(const std::optional<planning::SurfacingPlan>& plan, std::size_t waypoint);

/// The reverse of both, for the document of a stored plan.
/// Errors   nlohmann::json::exception when a member is missing or of another type; std::runtime_error for a time that
///          is none
[[nodiscard]] std::optional<planning::SurfacingPlan> parse_surfacing(const nlohmann::json& document);

}  // namespace floeplan::codec

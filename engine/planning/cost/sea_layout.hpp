#pragma once

#include <memory>
#include <optional>
#include <stop_token>

#include "engine/geo/local_projection.hpp"
#include "engine/ocean/environment.hpp"
#include "engine/planning/currents/flown_depths.hpp"
#include "engine/planning/currents/plane_currents.hpp"
#include "engine/planning/ice/under_ice.hpp"
#include "engine/planning/obstacles/encounter_map.hpp"
#include "engine/planning/obstacles/iceberg_discs.hpp"
#include "engine/planning/obstacles/timed_zones.hpp"
#include "engine/planning/obstacles/zone_rules.hpp"
#include "engine/planning/problem/plan_request.hpp"

/// Makes the parts of the leg cost model, each gridded for one request. A part is empty if environment and
/// request have no data for it. Once `stop` is requested, the parts stay incomplete and must not be used.
namespace floeplan::planning::cost {

/// The rules of the stored zones and of the request's own areas.
[[nodiscard]] obstacles::ZoneRules lay_out_zones(const ocean::Environment& environment,
                                                 const PlanRequest& request);

/// Searches keep a small extra distance from timed zones in space and time; the evaluation of a given route
/// does not.
[[nodiscard]] obstacles::TimedZones lay_out_timed_zones(const std::vector<ocean::Zone>& timed,
                                                        const PlanRequest& request,
                                                        const geo::LocalProjection& projection,
                                                        const plane::PlaneBox& area);

/// Time for which the drift of icebergs is computed while the vehicle is under way. It is six times the
/// duration of the straight route between the stops plus the requested extent of the grid, for detours and
/// head currents, and a day more. Rounded up to whole days, so that routes of similar length share it. 30
/// days if the vehicle may hold.
[[nodiscard]] core::Seconds drift_for_the_way(const PlanRequest& request);

/// The time after the first departure until which the drift of icebergs matters: the end of a route from the last
/// departure, or the end of the currents if later, but at most 30 days. All departures of a window get the drift that the
/// last one would have alone, so the result of a departure does not depend on the window.
[[nodiscard]] core::Seconds forecast_horizon(const ocean::Environment& environment,
                                             const PlanRequest& request);

/// Whether the vehicle may pass below icebergs or sea ice.
[[nodiscard]] bool passes_below(const ocean::Environment& environment, const PlanRequest& request);

/// The sea bed on a grid, if the vehicle may pass below icebergs or sea ice; otherwise null.
[[nodiscard]] std::shared_ptr<const obstacles::BedCells> lay_out_bed_below(
    const ocean::Environment& environment, const PlanRequest& request, const geo::LocalProjection& projection,
    const plane::PlaneBox& area, core::Metres cell, const std::stop_token& stop);

/// The drift of the icebergs for as long as it matters: from the last possible departure, or the wanted
/// arrival, for the time of a slow route with detours, and to the end of the currents; at most 30 days.
/// `bed`    sea bed below icebergs that may be passed under; null: any depth counts as deep enough there
[[nodiscard]] obstacles::IcebergDiscs lay_out_icebergs(
    const ocean::Environment& environment, const PlanRequest& request, const geo::LocalProjection& projection,
    const plane::PlaneBox& area, std::shared_ptr<const obstacles::BedCells> bed, const std::stop_token& stop);

[[nodiscard]] std::optional<obstacles::EncounterMap> lay_out_encounters(
    const obstacles::IcebergDiscs& icebergs, const ocean::Environment& environment,
    const PlanRequest& request, const plane::PlaneBox& area, const std::stop_token& stop);

/// `cell`   step of the safety map; the ice is sampled at the same step
/// `bed`    sea bed of the area; null: no depth is checked
[[nodiscard]] std::optional<ice::UnderIce> lay_out_ice(const ocean::Environment& environment,
                                                       const PlanRequest& request,
                                                       const geo::LocalProjection& projection,
                                                       const plane::PlaneBox& area, core::Metres cell,
                                                       std::shared_ptr<const obstacles::BedCells> bed,
                                                       const std::stop_token& stop);

/// `ice`: null if nothing is known of ice.
[[nodiscard]] std::shared_ptr<const currents::PlaneCurrents> lay_out_currents(
    const ocean::Environment& environment, const PlanRequest& request, const currents::FlownDepths& depths,
    const ice::UnderIce* ice, const geo::LocalProjection& projection, const plane::PlaneBox& area,
    const std::stop_token& stop);

}  // namespace floeplan::planning::cost

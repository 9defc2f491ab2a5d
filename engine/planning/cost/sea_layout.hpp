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

/// The parts of the leg cost model, each on the grid of one request. A part is empty if environment or request have
/// none of it. If `stop` is requested, the parts stay incomplete and must not be used.
namespace floeplan::planning::cost {

/// The rules of the stored zones and of the request's own areas.
[[nodiscard]] obstacles::ZoneRules lay_out_zones(const ocean::Environment& environment,
                                                 const PlanRequest& request);

/// Searches keep a little room from timed zones; the evaluation of a given route does not.
[[nodiscard]] obstacles::TimedZones lay_out_timed_zones(const std::vector<ocean::Zone>& timed,
                                                        const PlanRequest& request,
                                                        const geo::LocalProjection& projection,
                                                        const plane::PlaneBox& area);

/// Longest drift of icebergs while the vehicle is under way: six times the straight route between the stops with the
/// requested extent of the grid, for detours and head currents, plus a day. Rounded up to whole days, so that routes
/// of similar length share it. 30 days if the vehicle may hold on its route.
[[nodiscard]] core::Seconds drift_for_the_way(const PlanRequest& request);

/// The sea bed where icebergs may be passed under.
[[nodiscard]] std::shared_ptr<const obstacles::BedCells> lay_out_bed_below(
    const ocean::Environment& environment, const PlanRequest& request, const geo::LocalProjection& projection,
    const plane::PlaneBox& area, core::Metres cell, const std::stop_token& stop);

/// The drift of the icebergs for as long as it matters: from the last departure of a window, or the wanted arrival,
/// for a slow route with detours, and to the end of the currents; at most 30 days.
/// `bed`    null: below icebergs that may be passed under every depth is enough
[[nodiscard]] obstacles::IcebergDiscs lay_out_icebergs(
    const ocean::Environment& environment, const PlanRequest& request, const geo::LocalProjection& projection,
    const plane::PlaneBox& area, std::shared_ptr<const obstacles::BedCells> bed, const std::stop_token& stop);

[[nodiscard]] std::optional<obstacles::EncounterMap> lay_out_encounters(
    const obstacles::IcebergDiscs& icebergs, const ocean::Environment& environment,
    const PlanRequest& request, const plane::PlaneBox& area, const std::stop_token& stop);

/// `cell`   step of the safety map; the ice is sampled at the same step
/// `bed`    null: the sea bed is gridded where it is needed
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

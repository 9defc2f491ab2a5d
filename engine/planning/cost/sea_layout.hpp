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

/// The parts of a sea, each laid out as one request has it; empty where the environment or the request has none of it.
/// Once `stop` is requested they stay incomplete and must not be used.
namespace floeplan::planning::cost {

/// The rules of the environment's zones and of the request's own.
[[nodiscard]] obstacles::ZoneRules lay_out_zones(const ocean::Environment& environment,
                                                 const PlanRequest& request);

/// A way that is searched for keeps room from them, one that is given is judged as it is.
[[nodiscard]] obstacles::TimedZones lay_out_timed_zones(const std::vector<ocean::Zone>& timed,
                                                        const PlanRequest& request,
                                                        const geo::LocalProjection& projection,
                                                        const plane::PlaneBox& area);

/// How long icebergs drift while a vehicle is on its way, at most: six times the straight way from stop to
/// stop and the room that is asked for, for detours and head currents, and a day; whole days, so that ways of
/// about one length have the same. Where it may wait on its way, 30 days.
[[nodiscard]] core::Seconds drift_for_the_way(const PlanRequest& request);

/// Where icebergs may be passed under.
[[nodiscard]] std::shared_ptr<const obstacles::BedCells> lay_out_bed_below(
    const ocean::Environment& environment, const PlanRequest& request, const geo::LocalProjection& projection,
    const plane::PlaneBox& area, core::Metres cell, const std::stop_token& stop);

/// The icebergs' drift for as long as it matters: from the last departure of a window, or the wanted arrival,
/// on no less than a slow way with detours takes, and to the end of the currents, at most 30 days.
/// `bed`    null: every depth will do below those that may be passed under
[[nodiscard]] obstacles::IcebergDiscs lay_out_icebergs(
    const ocean::Environment& environment, const PlanRequest& request, const geo::LocalProjection& projection,
    const plane::PlaneBox& area, std::shared_ptr<const obstacles::BedCells> bed, const std::stop_token& stop);

[[nodiscard]] std::optional<obstacles::EncounterMap> lay_out_encounters(
    const obstacles::IcebergDiscs& icebergs, const ocean::Environment& environment,
    const PlanRequest& request, const plane::PlaneBox& area, const std::stop_token& stop);

/// `cell`   of the safety map: the ice is looked at as closely
/// `bed`    null: laid out where it is needed
[[nodiscard]] std::optional<ice::UnderIce> lay_out_ice(const ocean::Environment& environment,
                                                       const PlanRequest& request,
                                                       const geo::LocalProjection& projection,
                                                       const plane::PlaneBox& area, core::Metres cell,
                                                       std::shared_ptr<const obstacles::BedCells> bed,
                                                       const std::stop_token& stop);

/// `ice`: null where nothing is known of it.
[[nodiscard]] std::shared_ptr<const currents::PlaneCurrents> lay_out_currents(
    const ocean::Environment& environment, const PlanRequest& request, const currents::FlownDepths& depths,
    const ice::UnderIce* ice, const geo::LocalProjection& projection, const plane::PlaneBox& area,
    const std::stop_token& stop);

}  // namespace floeplan::planning::cost

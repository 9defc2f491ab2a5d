#pragma once

#include <optional>
#include <vector>

#include "api/codec/exports/map_picture.hpp"
#include "api/codec/inputs/plan_inputs.hpp"
#include "engine/mission/writing/hold_lists.hpp"
#include "engine/mission/writing/safe_places.hpp"
#include "engine/mission/writing/shoals.hpp"
#include "engine/planning/problem/plan.hpp"
#include "engine/vehicle/glider_profile.hpp"
#include "storage/repository/work/plan_repository.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::service {

/// The inputs of a stored plan; nullopt if an older version stored them in another form.
[[nodiscard]] std::optional<codec::PlanInputs> inputs_of(const repository::PlanRecord& record);

/// The vehicle of a stored plan, with the settings in its request.
[[nodiscard]] vehicle::GliderProfile vehicle_of(const repository::PlanRecord& record,
                                                const planning::Plan& plan);

/// The shoalest place on each leg of a stored plan, in the newest depths that its request selects; empty if
/// there are none, or the request cannot be read.
[[nodiscard]] std::vector<std::optional<mission::Shoal>> shoals_of(sql::Connection& db,
                                                                   const repository::PlanRecord& record,
                                                                   const planning::Plan& plan);

/// How the holds of a stored plan are flown: with the requested circle, in the newest currents that its
/// request selects; if these cannot be read, in the mean currents of its legs.
[[nodiscard]] mission::HoldOptions holds_of(sql::Connection& db, const repository::PlanRecord& record,
                                            const planning::Plan& plan);

/// Safe places with the newest stored depths, coastlines, ice, icebergs and zones there during the plan. The
/// plan's request decides which sightings count.
[[nodiscard]] std::vector<mission::SafePlace> safe_places_of(sql::Connection& db,
                                                             const repository::PlanRecord& record,
                                                             const planning::Plan& plan,
                                                             const std::vector<geo::LonLat>& places);

/// The sea ice at the departure of a stored plan, from its own ice data as far as these are still stored; nullopt
/// if it has none. Of several products it takes, at each place, the one that describes the time best
/// (ocean::IceStanding), and of equal ones the first.
[[nodiscard]] std::optional<codec::SeaIce> sea_ice_of(sql::Connection& db,
                                                      const repository::PlanRecord& record,
                                                      const planning::Plan& plan,
                                                      const geo::BoundingBox& area);

}  // namespace floeplan::service

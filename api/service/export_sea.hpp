#pragma once

#include <optional>
#include <vector>

#include "api/codec/inputs/plan_inputs.hpp"
#include "engine/mission/writing/hold_lists.hpp"
#include "engine/mission/writing/safe_places.hpp"
#include "engine/mission/writing/shoals.hpp"
#include "engine/planning/problem/plan.hpp"
#include "engine/vehicle/glider_profile.hpp"
#include "storage/repository/work/plan_repository.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::service {

/// The inputs that the plan was made with; nothing when an older version stored them in another form.
[[nodiscard]] std::optional<codec::PlanInputs> inputs_of(const repository::PlanRecord& record);

/// The vehicle that a stored plan is for, with what its request says of it.
[[nodiscard]] vehicle::GliderProfile vehicle_of(const repository::PlanRecord& record,
                                                const planning::Plan& plan);

/// The least water on the legs of a stored plan, by the newest of the depths that it chose; empty where there are none,
/// or the choice cannot be read any more.
[[nodiscard]] std::vector<std::optional<mission::Shoal>> shoals_of(sql::Connection& db,
                                                                   const repository::PlanRecord& record,
                                                                   const planning::Plan& plan);

/// How the holds of a stored plan are flown: by the circle that was asked for, in the newest of the currents that it
/// chose; where those cannot be read any more, in the mean currents of its legs.
[[nodiscard]] mission::HoldOptions holds_of(sql::Connection& db, const repository::PlanRecord& record,
                                            const planning::Plan& plan);

/// The places with what the newest stored depths, coastlines, ice, icebergs and areas say of them while the plan lasts.
/// Which sightings count says the request of the plan.
[[nodiscard]] std::vector<mission::SafePlace> safe_places_of(sql::Connection& db,
                                                             const repository::PlanRecord& record,
                                                             const planning::Plan& plan,
                                                             const std::vector<geo::LonLat>& places);

}  // namespace floeplan::service

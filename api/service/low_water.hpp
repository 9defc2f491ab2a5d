#pragma once

#include <optional>

#include "engine/messages/message.hpp"
#include "engine/ocean/environment.hpp"
#include "engine/planning/problem/plan.hpp"
#include "engine/vehicle/glider_profile.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::service {

/// A caution if, at the time of a passage, the stored water level lies so far below its datum that the dives of the plan
/// reach the bed: plans take depths from the bathymetry alone. It has the place where the dives reach furthest. The levels
/// are those that the probe shows there.
/// Outside  nullopt where no water level or no depth is known
[[nodiscard]] std::optional<messages::Message> low_water_caution(sql::Connection& db,
                                                                 const ocean::Environment& environment,
                                                                 const vehicle::GliderProfile& vehicle,
                                                                 const planning::Plan& plan);

}  // namespace floeplan::service

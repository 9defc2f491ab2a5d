#pragma once

#include <string>
#include <vector>

#include "engine/core/violation.hpp"
#include "engine/geo/lon_lat.hpp"
#include "engine/messages/message.hpp"
#include "engine/ocean/environment.hpp"
#include "engine/planning/problem/plan.hpp"
#include "engine/planning/problem/plan_request.hpp"

namespace floeplan::mission {

/// How a yo dives and drives, all the way alike.
struct YoDives {
  core::Metres climb_to{};
  core::Metres dive_depth{};
  bool on_thruster{false};
};

/// The request for a vehicle that dives and drives as the yo does. Depths between which there is no room for a dive
/// leave those of the vehicle.
[[nodiscard]] planning::PlanRequest flown_with(planning::PlanRequest request, const YoDives& yo);

/// Whether the one yo of a plan's mission flies in other water than the plan was made in, or on another drive: it
/// keeps below the deepest ice of any leg on all of them, and runs the thruster on all or on none.
[[nodiscard]] bool flies_otherwise(const planning::Plan& plan, const vehicle::GliderProfile& vehicle);

/// What becomes of a plan that is flown by one yo.
struct YoFlight {
  core::Violations violations;  // the vehicle does not come through
  std::vector<messages::Message>
      messages;  // it comes through, at other times or with another draw on the battery
};

/// Follows the way of a plan by the dives and the drive of its mission's yo.
/// `route`    the plan's waypoints with all their digits
/// `request`  that the plan was made by
/// Errors     as check_route
[[nodiscard]] YoFlight fly_by_yo(const ocean::Environment& environment, const std::vector<geo::LonLat>& route,
                                 const planning::PlanRequest& request, const planning::Plan& plan);

}  // namespace floeplan::mission

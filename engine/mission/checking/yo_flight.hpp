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

/// Depths and propulsion of a yo, equal on the whole route.
struct YoDives {
  core::Metres climb_to{};
  core::Metres dive_depth{};
  bool on_thruster{false};
};

/// The request for a vehicle with the dives and propulsion of the yo. If the yo's depths leave no room for a
/// dive, the vehicle's depths stay.
[[nodiscard]] planning::PlanRequest flown_with(planning::PlanRequest request, const YoDives& yo);

/// Whether the single yo of a plan's mission dives to other depths, or with other propulsion, than the plan.
/// A yo stays below the deepest ice of any leg on all legs, and runs the thruster on all legs or on none.
[[nodiscard]] bool flies_otherwise(const planning::Plan& plan, const vehicle::GliderProfile& vehicle);

/// Result of flying a plan with one yo.
struct YoFlight {
  core::Violations violations;  // reasons why the vehicle does not reach the goal
  std::vector<messages::Message>
      messages;  // it reaches the goal, but at other times or with another use of the battery
};

/// Follows the route of a plan with the dives and propulsion of its mission's yo.
/// `route`    the plan's waypoints in full precision
/// `request`  the one of the plan
/// Errors     as check_route
[[nodiscard]] YoFlight fly_by_yo(const ocean::Environment& environment, const std::vector<geo::LonLat>& route,
                                 const planning::PlanRequest& request, const planning::Plan& plan);

}  // namespace floeplan::mission

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/geo/lon_lat.hpp"
#include "engine/geo/velocity.hpp"
#include "engine/messages/message.hpp"
#include "engine/mission/writing/hold_legs.hpp"
#include "engine/ocean/environment.hpp"
#include "engine/planning/problem/hold_rules.hpp"
#include "engine/planning/problem/plan.hpp"
#include "engine/vehicle/glider_profile.hpp"

namespace floeplan::mission {

/// Shortest hold that gets a list of its own. In a shorter one the vehicle would be at the surface for about
/// that time at every turn.
inline constexpr core::Seconds least_listed_hold{600.0};

/// Says how the vehicle flies the holds of a plan.
struct HoldOptions {
  core::Metres radius{planning::HoldRules{}.radius};  // hold circle of the plan's request
  vehicle::GliderProfile vehicle{};
  bool surfaces{true};  // whether it surfaces at turns and intervals; false if the plan passes below ice
  core::Seconds between_surfacings{3.0 * 3600.0};  // interval, as in the vendor's stock missions
  /// For each waypoint: currents from the beginning of its hold to its end, as in HoldFlight::currents. If
  /// empty, the mean currents of the legs before and after are used.
  std::vector<std::vector<geo::VelocityEn>> currents{};
};

/// Whether the plan has a hold at the waypoint that needs a list of its own: long enough, and the vehicle may
/// surface there.
/// Precondition  the plan has this waypoint
[[nodiscard]] bool is_held_at(const planning::Plan& plan, std::size_t waypoint);

/// Whether the plan has a hold that needs a list of its own at any waypoint.
[[nodiscard]] bool has_holds(const planning::Plan& plan);

/// The currents of each hold that needs a list of its own, every half hour, in the form of
/// HoldOptions::currents; empty where the data do not reach.
[[nodiscard]] std::vector<std::vector<geo::VelocityEn>> hold_currents(const ocean::Environment& sea,
                                                                      const planning::Plan& plan,
                                                                      const vehicle::GliderProfile& vehicle);

/// The conditions of the hold at a waypoint that has a leg after it.
[[nodiscard]] HoldFlight hold_flight(const planning::Plan& plan, std::size_t waypoint,
                                     const HoldOptions& options);

/// Instructions to the pilot for each hold of ten minutes or more, for formats that cannot order holds.
[[nodiscard]] std::vector<messages::Message> messages_without_holds(const planning::Plan& plan,
                                                                    const std::string& format);

/// The places of both rows of the list of a hold at `place`.
[[nodiscard]] std::vector<geo::LonLat> hold_rows(geo::LonLat place, const HoldLegs& legs);

}  // namespace floeplan::mission

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

/// A shorter hold has no list of its own: the vehicle is at the surface for about as long at every turn.
inline constexpr core::Seconds least_listed_hold{600.0};

/// How the holds of a plan are flown.
struct HoldOptions {
  core::Metres radius{planning::HoldRules{}.radius};  // of the circle that the plan was asked to keep to
  vehicle::GliderProfile vehicle{};
  bool surfaces{true};  // at turns and by the clock, unless the plan passes below ice
  core::Seconds between_surfacings{3.0 * 3600.0};  // by the clock, as the vendor's stock missions
  /// At each waypoint, from the beginning of its hold to its end, as HoldFlight::currents; where that is empty the mean
  /// currents of the legs before and after stand in.
  std::vector<std::vector<geo::VelocityEn>> currents{};
};

/// Whether the vehicle holds there and may come up meanwhile: it needs a list of its own for that.
/// Precondition  the plan has such a waypoint
[[nodiscard]] bool is_held_at(const planning::Plan& plan, std::size_t waypoint);

/// Anywhere.
[[nodiscard]] bool has_holds(const planning::Plan& plan);

/// The currents of each such hold as HoldOptions takes them, every half hour; none where the data do not reach.
[[nodiscard]] std::vector<std::vector<geo::VelocityEn>> hold_currents(const ocean::Environment& sea,
                                                                      const planning::Plan& plan,
                                                                      const vehicle::GliderProfile& vehicle);

/// The hold at a waypoint that a leg follows.
[[nodiscard]] HoldFlight hold_flight(const planning::Plan& plan, std::size_t waypoint,
                                     const HoldOptions& options);

/// What the pilot has to do at each hold of ten minutes or more, where the vehicle's files do not tell of it.
[[nodiscard]] std::vector<messages::Message> messages_without_holds(const planning::Plan& plan,
                                                                    const std::string& format);

/// Both rows of its list.
[[nodiscard]] std::vector<geo::LonLat> hold_rows(geo::LonLat place, const HoldLegs& legs);

}  // namespace floeplan::mission

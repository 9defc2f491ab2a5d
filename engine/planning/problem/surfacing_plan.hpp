#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/geo/lon_lat.hpp"
#include "engine/planning/problem/carried_way.hpp"
#include "engine/vehicle/drive.hpp"

namespace floeplan::planning {

/// The deepest ice within the position error of a route: the vehicle may come below it unnoticed.
struct IceBeside {
  core::Metres upper_turn{};  // upper turn that dives need below this ice; 0: no ice
  core::Metres error{};       // position error there
  geo::LonLat place{};        // place on the route
};

/// Ice farther away is not reported. The limit exceeds any position error: a week in an unknown current of
/// 0.3 m/s.
inline constexpr core::Metres farthest_ice_told{200'000.0};

/// The ice at one waypoint at its ETA, and the state of the vehicle there.
struct SurfacingState {
  bool may_surface{true};
  core::Seconds since_surfacing{};  // since the last possible surfacing
  /// Dead-reckoning error since the last fix. It grows by the rules, and by the drift: the plan's currents
  /// minus the current that the vehicle assumes. The vehicle assumes the mean current between its last two
  /// fixes, and none before the first fix.
  core::Metres position_error{};
  core::Metres least_upper_turn{};  // upper turn that dives need here; 0 if the vehicle may surface
  /// The deepest upper turn needed on the leg to here and during the hold before it; 0: no ice above. Empty
  /// at the start, and in plans of versions that did not store it.
  std::optional<core::Metres> leg_upper_turn{};
  /// Length of the last part of the route to here without ice that dives must turn below, at most back to the
  /// start; 0 if such ice is above. Empty in plans of versions that did not store it.
  std::optional<core::Metres> ice_free_before{};
  /// Position error by the rules if the vehicle had no fix since the start, without the drift in currents. Empty in
  /// plans of versions that did not store it.
  std::optional<core::Metres> error_without_fix{};
  /// Distance to the nearest ice that dives must turn below, in any direction. Empty where there is none within
  /// `farthest_ice_told`, and in plans of versions that did not store it.
  std::optional<core::Metres> nearest_ice{};
};

/// The displacement by currents that the vehicle does not know of.
struct Reckoned {
  CarriedWay off;                  // from the position that the vehicle assumes to its true position
  motion::CurrentXy with_current;  // the current that the vehicle assumes
};

/// A planned surfacing, with a fix of the position.
struct PlannedSurfacing {
  geo::LonLat place;
  core::UtcTime time;
  core::Metres position_error{};  // just before the fix
  /// Distance to the nearest ice that dives must turn below, in any direction. Empty where there is none within the
  /// position error, and in plans of versions that did not store it.
  std::optional<core::Metres> nearest_ice{};
};

/// The escape route of a waypoint: the fastest one to a place where the vehicle may surface.
struct EscapeWay {
  std::vector<geo::LonLat>
      way;  // from the waypoint to open water; a single point if the vehicle may surface at the waypoint
  std::vector<vehicle::Drive> drives{};  // one for each leg; empty in plans of older versions
  std::optional<double> course_deg;      // of the first leg, clockwise from true north
  core::Metres distance{};
  core::Seconds time{};
  core::Joules energy{};  // drawn on the escape route
};

/// A stretch of one leg, and of the hold before it, with ice or icebergs above that dives must turn below. It begins and ends
/// halfway between the checks of the ice above that differ, so each end is exact to half the distance between checks.
struct StretchBelowIce {
  std::size_t waypoint{};  // that the leg leads to
  geo::LonLat from;
  geo::LonLat to;
  core::UtcTime enters;
  core::Seconds time{};
  core::Metres length{};  // on the ellipsoid
};

/// Where and when the vehicle can surface, and its position error.
struct SurfacingPlan {
  core::Seconds longest_without{};  // the longest time between places where it may surface
  /// The longest time between places that it cannot miss by its position error and between which it passes a lead; 0
  /// where it passes none. Not stored.
  core::Seconds longest_without_sure{};
  std::optional<geo::LonLat>
      missed_lead{};  // the first lead that the vehicle could miss in that time; not stored
  core::Metres unknown_ice{};                // length of the route on which the ice is unknown
  std::vector<SurfacingState> waypoints;     // one for each
  std::vector<Reckoned> reckoned;            // one for each waypoint; not stored
  std::vector<PlannedSurfacing> surfacings;  // empty unless the request gives an interval
  std::vector<EscapeWay> escapes;            // one for each waypoint, if the request asks for them
  IceBeside ice_beside{};                    // the deepest ice within the position error; not stored
  /// In the order of the route. Empty in plans of versions that did not store it.
  std::optional<std::vector<StretchBelowIce>> below_ice{};
};

/// Sum over the stretches below ice or icebergs; empty where the plan does not tell them.
[[nodiscard]] std::optional<core::Metres> length_below_ice(const SurfacingPlan& plan);
[[nodiscard]] std::optional<core::Seconds> time_below_ice(const SurfacingPlan& plan);

}  // namespace floeplan::planning

#pragma once

#include <optional>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/geo/lon_lat.hpp"
#include "engine/planning/problem/carried_way.hpp"
#include "engine/vehicle/drive.hpp"

namespace floeplan::planning {

/// The deepest ice near a way: where a vehicle whose position is not known for certain may come to be.
struct IceBeside {
  core::Metres upper_turn{};  // that the ice asks dives for; 0: there is none
  core::Metres error{};       // of the position there
  geo::LonLat place{};        // on the way
};

/// Farther than a vehicle may be off at the end of any goto list: a week in a current of 0.3 m/s that it does not know.
inline constexpr core::Metres farthest_ice_told{200'000.0};

/// What ice means to the vehicle at one waypoint, at its ETA.
struct SurfacingState {
  bool may_surface{true};
  core::Seconds since_surfacing{};  // since the last place where it might have surfaced
  /// Of dead reckoning since the last fix: grown by the rules, and by how far the currents of the plan carry the
  /// vehicle against the one that it takes them for, the mean of its dive before that fix (none before the first).
  core::Metres position_error{};
  core::Metres least_upper_turn{};  // how deep the dives must turn here; 0 where the vehicle may surface
  /// How deep they must turn where that is deepest on the leg that leads here and in the wait before it; 0 where
  /// nothing is above. Empty at the start, and in plans stored before it was kept.
  std::optional<core::Metres> leg_upper_turn{};
  /// Length of the way up to here above which there has been no ice that dives must turn below, back to the start at
  /// most; 0 where there is. Empty in plans stored before it was kept.
  std::optional<core::Metres> ice_free_before{};
  /// Grown by the rules since the start, were there no fix on the way, without what the currents carry. Empty in plans
  /// stored before it was kept.
  std::optional<core::Metres> error_without_fix{};
  /// From here to the nearest ice that dives must turn below, to any side. Empty where there is none within
  /// `farthest_ice_told`, and in plans stored before it was kept.
  std::optional<core::Metres> nearest_ice{};
};

/// The part of the currents in the error of position.
struct Reckoned {
  CarriedWay off;                  // how far they have carried the vehicle from where it takes itself to be
  motion::CurrentXy with_current;  // that it takes itself to be in
};

/// A planned surfacing, with a fix of the position.
struct PlannedSurfacing {
  geo::LonLat place;
  core::UtcTime time;
  core::Metres position_error{};  // just before the fix
  /// To the nearest ice that dives must turn below, to any side. Empty where there is none within that error, and in
  /// plans stored before it was kept.
  std::optional<core::Metres> nearest_ice{};
};

/// The fastest way from a waypoint to a place where the vehicle may surface.
struct EscapeWay {
  std::vector<geo::LonLat>
      way;  // the waypoint first, the open water last; alone where it may surface at once
  std::vector<vehicle::Drive> drives{};  // one for each of its legs; none in plans of older versions
  std::optional<double> course_deg;      // at its start, clockwise from true north
  core::Metres distance{};
  core::Seconds time{};
  core::Joules energy{};  // drawn on it
};

/// When and where the vehicle can show itself, and how well it knows where it is.
struct SurfacingPlan {
  core::Seconds longest_without{};  // the longest time between places where it may surface
  core::Seconds
      longest_without_sure{};  // counting those that its position error cannot miss; not kept stored
  core::Metres unknown_ice{};  // length of the route where nothing is known of the ice
  std::vector<SurfacingState> waypoints;     // one for each
  std::vector<Reckoned> reckoned;            // one for each waypoint; not kept with stored plans
  std::vector<PlannedSurfacing> surfacings;  // empty unless an interval was asked for
  std::vector<EscapeWay> escapes;            // one for each waypoint, if they were asked for
  IceBeside ice_beside{};  // the deepest within the error of position; not kept with stored plans
};

}  // namespace floeplan::planning

#pragma once

#include <optional>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/geo/bearing.hpp"
#include "engine/geo/velocity.hpp"
#include "engine/vehicle/dive_band.hpp"

namespace floeplan::mission {

/// The conditions of a hold by a goto list.
struct HoldFlight {
  core::Seconds wait{};  // from the arrival to the departure
  core::Metres circle{};
  core::MetresPerSecond speed{};       // horizontal, through the water
  core::MetresPerSecond vertical{};    // of dives and climbs
  vehicle::DiveBand band{};            // depths of the dives at the place
  bool surfaces{true};                 // at turns and intervals; false: only at the beginning and the end
  core::Seconds between_surfacings{};  // interval of surfacings
  geo::Bearing course{geo::Bearing::degrees(0.0)};  // course of the next leg
  /// Currents averaged over the depths flown, at equal time steps from the beginning of the wait to its end.
  /// One value: steady; none: still water.
  std::vector<geo::VelocityEn> currents{};
};

/// A goto list of two rows between which the vehicle goes to and fro.
struct HoldLegs {
  geo::Bearing axis{geo::Bearing::degrees(0.0)};  // from first to second row; the place is half-way
  core::Metres apart{};                           // distance of the rows
  core::Metres radius{};                          // within which a row counts as reached
  int legs{};                // num_legs_to_run, including the leg to the first row; -1: without end
  core::Seconds expected{};  // time from the arrival to the departure; of a list without end the wait
};

/// Larger numbers of legs (about a day) are not ordered: a glider's speed is known to some 5 %, so they would
/// end an hour early or late. A judgement.
inline constexpr int most_hold_legs = 24;

/// Radius of the rows of a hold within the circle, and of the waypoint before them.
[[nodiscard]] core::Metres turning_radius(core::Metres circle);

/// A list of legs that lasts as long as the wait.
/// Rows      across the main axis of the current: legs in both directions then take the same time, and an
///           error of the current changes it least. At a current of 0.8 of the speed, a tenth more makes a
///           leg across a quarter longer, but one against it two thirds. In still water across the course of
///           the next leg. Never outside the circle
/// Time      as a Slocum flies the list by the vendor's stock missions: it surfaces at its arrival, at every
///           turn, at intervals and at the end, for six minutes each, during which it drifts; under water it
///           steers for the next row (motion::waypoint_heading). Number and length of the legs suit the wait
///           best: of the lists within 1 % of it the one with eight legs, so that the pilot can end the hold
///           at a turn near its end; otherwise the nearest number Without end  if no number of legs is within
///           5 % of the wait: the pilot ends the hold. If the vehicle does not surface meanwhile, the longest
///           list that is shorter, to be flown more than once
/// Edges     empty for a wait shorter than three of the shortest legs
[[nodiscard]] std::optional<HoldLegs> hold_legs(const HoldFlight& flight);

/// The time from the arrival to the departure with such a list. Empty for a list without end, and if it takes
/// hours longer than the wait.
[[nodiscard]] std::optional<core::Seconds> hold_time(const HoldFlight& flight, const HoldLegs& legs);

}  // namespace floeplan::mission

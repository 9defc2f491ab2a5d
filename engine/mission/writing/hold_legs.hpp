#pragma once

#include <optional>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/geo/bearing.hpp"
#include "engine/geo/velocity.hpp"
#include "engine/vehicle/dive_band.hpp"

namespace floeplan::mission {

/// What a hold by a goto list depends on.
struct HoldFlight {
  core::Seconds wait{};  // from the arrival to the departure
  core::Metres circle{};
  core::MetresPerSecond speed{};     // horizontal, through the water
  core::MetresPerSecond vertical{};  // of dives and climbs
  vehicle::DiveBand band{};          // flown at the place
  bool surfaces{true};               // at every turn, and by the clock; false: at the begin and the end alone
  core::Seconds between_surfacings{};               // by the clock
  geo::Bearing course{geo::Bearing::degrees(0.0)};  // of the next leg
  /// Averaged over the depths flown, at equal steps from the beginning of the wait to its end; one: steady; none: still
  /// water.
  std::vector<geo::VelocityEn> currents{};
};

/// A goto list of two rows between which the vehicle goes to and fro.
struct HoldLegs {
  geo::Bearing axis{geo::Bearing::degrees(0.0)};  // from the first row to the second, the place in the middle
  core::Metres apart{};                           // the rows
  core::Metres radius{};                          // in which one is reached
  int legs{};                // num_legs_to_run, the way to the first row included; -1: for ever
  core::Seconds expected{};  // from the arrival to the departure; of a list without end the wait
};

/// More legs than that, about a day of them, are not counted: a glider knows its speed to some 5 %, so that they would
/// end an hour early or late. A judgement.
inline constexpr int most_hold_legs = 24;

/// In which the rows of a hold within such a circle are reached, and the place itself before it.
[[nodiscard]] core::Metres turning_radius(core::Metres circle);

/// The legs that last as long as the wait.
/// Rows      across the main axis of the current, where legs both ways take the same time and an error of the current
///           changes it least: at 0.8 of the speed a tenth more makes a leg across a quarter longer, one against it two
///           thirds. In still water across the course of the next leg. Never farther from the place than the circle
/// Time      as a Slocum flies the list by the vendor's stock missions: it comes up at its arrival, at every turn, by
///           the clock and at the end, each time for six minutes in which it drifts, and steers for the next row
///           meanwhile (motion::waypoint_heading). The legs are as many and as long as suit the wait best: of those
///           within 1 % of it eight, so that the pilot can end the hold at a turn near its end, or else as few more or as
///           many fewer as there are
/// Without end  where no number of legs comes within 5 % of the wait: the pilot ends the hold. Where the vehicle does
///           not come up meanwhile, the longest list that is shorter, to be flown more than once
/// Edges     empty for a wait that is shorter than three of the shortest legs take
[[nodiscard]] std::optional<HoldLegs> hold_legs(const HoldFlight& flight);

/// How long a list of so many legs between such rows keeps the vehicle, from the arrival to the departure; empty for a
/// list without end, and where it takes hours longer than the wait.
[[nodiscard]] std::optional<core::Seconds> hold_time(const HoldFlight& flight, const HoldLegs& legs);

}  // namespace floeplan::mission

#pragma once

#include <optional>

#include "engine/core/units.hpp"
#include "engine/core/violation.hpp"

namespace floeplan::planning {

/// The rules of a vehicle under sea ice.
struct UnderIceRules {
  /// The vehicle may surface where ice covers at most this share of the water. Default: open water in the WMO's sense,
  /// ice of less than one tenth.
  /// Source  WMO Sea-Ice Nomenclature, WMO-No. 259, 4.2.6
  double max_concentration_to_surface{0.1};
  /// Vertical distance between the underside of the ice and the upper turn. Default: as much as the vehicles keep
  /// above the sea bed, because turns overshoot by metres.
  core::Metres margin_below_ice{10.0};
  /// The deepest keel that is assumed where the data have no thickness.
  /// Source  Amundrud, Melling and Ingram 2004, doi:10.1029/2003JC002031, as the CICE sea-ice model uses it for the
  ///         largest keels that ground
  core::Metres draft_if_unknown{30.0};
  std::optional<core::Seconds> max_time_without_surfacing{};  // between places to surface; empty: no limit
  std::optional<core::Seconds>
      surfacing_interval{};  // time between planned surfacings; empty: none are planned
  bool escape_plan{false};   // asks for an escape route from every waypoint
  /// Growth of the dead-reckoning error with the distance through water.
  /// Source  Claus and Bachmayer 2015, Terrain-aided navigation for an underwater glider, J. Field Robotics 32,
  ///         doi:10.1002/rob.21563: 5.5 km after 91 km with a Slocum glider in a sheltered fjord
  double dead_reckoning_share{0.06};
  /// Error of the plan's currents, whose direction is taken as constant between two fixes. Default: half the typical
  /// error of a forecast in the open sea, because the vehicle corrects for the current that it measured before the
  /// dive.
  core::MetresPerSecond current_uncertainty{0.05};

  [[nodiscard]] core::Violations violations() const;  // empty when valid, otherwise all of them
};

/// Ratio of the draft of the deepest keel in a field of level ice to the thickness of that ice.
/// Source  Lemieux, Dupont, Blain, Roy, Smith and Flato 2016, doi:10.1002/2016JC012006: the largest keel of a grid
///         cell is taken as eight times its mean thickness where ice grounds
inline constexpr double keel_over_thickness = 8.0;

}  // namespace floeplan::planning

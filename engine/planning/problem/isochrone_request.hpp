#pragma once

#include <optional>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/core/violation.hpp"
#include "engine/geo/bounding_box.hpp"
#include "engine/geo/lon_lat.hpp"
#include "engine/planning/problem/iceberg_rules.hpp"
#include "engine/planning/problem/plan_request.hpp"
#include "engine/planning/problem/under_ice_rules.hpp"
#include "engine/vehicle/glider_profile.hpp"

namespace floeplan::planning {

/// A request for isochrones: where the vehicle can be after given times, or from where it can still arrive.
struct IsochroneRequest {
  enum class Direction {
    from,  // the vehicle leaves `place` at `time`
    to     // the vehicle must be at `place` by `time`
  };
  static constexpr std::size_t most_spans = 48;
  static constexpr core::Seconds longest_span{30.0 * 86400.0};

  Direction direction{Direction::from};
  geo::LonLat place;
  core::UtcTime time;
  std::vector<core::Seconds> spans;  // counted forwards from `time`, or backwards
  vehicle::GliderProfile vehicle;
  std::optional<core::Metres>
      spacing;  // of the grid; default: a hundredth of the distance in still water, 100 m to 5 km
  /// Neighbourhood of the grid, 1 to 5 sectors. Empty: 3, or 5 where currents are as fast as the vehicle.
  std::optional<int> sectors{};
  std::vector<ocean::Zone> zones;  // obeyed in addition to those of the environment
  IcebergRules icebergs;
  UnderIceRules under_ice;  // planned surfacings and escape routes are ignored
  double edge_tolerance{1e-4};

  [[nodiscard]] core::Violations violations() const;
  /// The longest of `spans`.
  [[nodiscard]] core::Seconds reach() const;
  /// Beginning and end of the period in which the vehicle is under way.
  [[nodiscard]] core::UtcTime begin() const;
  [[nodiscard]] core::UtcTime end() const;
  /// Horizontal speed of the faster propulsion, if the vehicle has a thruster; otherwise of the buoyancy
  /// engine.
  [[nodiscard]] core::MetresPerSecond through_water() const;
  /// Spacing of the grid: as requested, or the default.
  [[nodiscard]] core::Metres step() const;
  /// Data are used up to this distance from the place: three times the distance travelled in still water.
  /// Only currents twice as fast as the vehicle carry it further; the result then says that its area was cut.
  [[nodiscard]] core::Metres data_radius() const;
};

/// The area whose data the answer may use.
[[nodiscard]] geo::BoundingBox reach_area(const IsochroneRequest& request);

/// A plan request with the same vehicle, rules and time, for code that makes a leg cost model. Start and goal
/// are both `request.place`.
[[nodiscard]] PlanRequest voyage_of(const IsochroneRequest& request);

}  // namespace floeplan::planning

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

/// Where can the vehicle be after these times, or from where can it still come?
struct IsochroneRequest {
  enum class Direction {
    from,  // it leaves `place` at `time`
    to     // it is to be at `place` by `time`
  };
  static constexpr std::size_t most_spans = 48;
  static constexpr core::Seconds longest_span{30.0 * 86400.0};

  Direction direction{Direction::from};
  geo::LonLat place;
  core::UtcTime time;
  std::vector<core::Seconds> spans;  // after `time`, or before it
  vehicle::GliderProfile vehicle;
  std::optional<core::Metres>
      spacing;  // of the grid; default a hundredth of the way in still water, 100 m to 5 km
  /// Reach of the grid's edges, 1 to 5; empty: 3, and 5 where currents are as fast as the vehicle.
  std::optional<int> sectors{};
  std::vector<ocean::Zone> zones;  // obeyed beside those of the environment
  IcebergRules icebergs;
  UnderIceRules under_ice;  // planned surfacings and escapes are of no account
  double edge_tolerance{1e-4};

  [[nodiscard]] core::Violations violations() const;
  /// The longest span.
  [[nodiscard]] core::Seconds reach() const;
  /// The period that the vehicle is under way in.
  [[nodiscard]] core::UtcTime begin() const;
  [[nodiscard]] core::UtcTime end() const;
  /// Of the faster drive, where the vehicle has a thruster.
  [[nodiscard]] core::MetresPerSecond through_water() const;
  /// Step of the grid: as asked for, or by default.
  [[nodiscard]] core::Metres step() const;
  /// How far from the place data are looked at: three times as far as in still water. A vehicle that drifts further
  /// is carried by currents twice as fast as itself; the result then says that its area was cut.
  [[nodiscard]] core::Metres data_radius() const;
};

/// Area whose data the answer may use.
[[nodiscard]] geo::BoundingBox reach_area(const IsochroneRequest& request);

/// The same vehicle under the same rules at the same time, for what lays out a sea. Its ends are the place.
[[nodiscard]] PlanRequest voyage_of(const IsochroneRequest& request);

}  // namespace floeplan::planning

#pragma once

#include <array>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/geo/local_projection.hpp"
#include "engine/planning/cost/sea.hpp"
#include "engine/planning/problem/time_span.hpp"

namespace floeplan::planning::cost {

/// The circle within which a vehicle holds station. A glider cannot stand still: it drifts away while it
/// dives, makes way against the current and comes back.
/// Below ice the vehicle has no fix. The radius then grows by the dead-reckoning error until the next
/// surfacing. If the time without surfacing is not limited, this error has no bound, so the vehicle does not
/// hold below ice.
/// Accuracy  currents, timed zones, land and depths are checked at the centre and at four or eight points of
///           the rim
class HoldCircle {
 public:
  /// `sea` is borrowed and must outlive the circle.
  HoldCircle(const Sea& sea, geo::PlanePoint centre);

  /// True if nothing permanent closes any part of the circle: land, too shallow water, zones without times,
  /// icebergs that do not move. False also if the vehicle may be below ice there and its position error has
  /// no bound.
  [[nodiscard]] bool is_open() const { return is_open_; }
  /// Whether the vehicle can stay within the circle at `time`: at all checked points the current is known and
  /// at most `hold_share` of the vehicle's speed, and there is room below the ice.
  [[nodiscard]] bool is_kept(core::Seconds time) const;
  /// Whether `is_kept` is true at all times with known currents. Precomputed: true is certain, false means
  /// that it is unknown.
  [[nodiscard]] bool is_always_kept() const;
  /// The times at which a timed zone or a moving iceberg touches the circle: ascending, disjoint.
  [[nodiscard]] std::vector<TimeSpan> closed_times() const;
  [[nodiscard]] bool is_below_ice() const { return is_below_ice_; }

 private:
  const Sea& sea_;
  geo::PlanePoint centre_;
  bool is_below_ice_;  // the centre may be below ice at some time
  core::Metres radius_;
  std::array<geo::PlanePoint, 5> looks_;
  bool is_open_;
};

/// Strongest current in which a vehicle can hold, as a share of its speed through water. A judgement: with
/// the rest of its speed the vehicle comes back to the centre.
inline constexpr double hold_share = 0.8;

}  // namespace floeplan::planning::cost

#pragma once

#include <array>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/geo/local_projection.hpp"
#include "engine/planning/cost/sea.hpp"
#include "engine/planning/problem/time_span.hpp"

namespace floeplan::planning::cost {

/// The circle that a vehicle keeps to while it holds station at a place. A glider cannot stand still: it makes way
/// against the current, drifts off between its dives, and comes back.
/// Below ice, where it has no fix, the circle is as much wider as its dead reckoning may be wrong by when it must come
/// to the surface; where that time is not bounded the vehicle does not hold below ice at all.
/// Accuracy  currents, timed zones, land and depths are looked at in the centre and at four or eight points of the rim
class HoldCircle {
 public:
  /// `sea` is borrowed and outlives the circle.
  HoldCircle(const Sea& sea, geo::PlanePoint centre);

  /// Whether nothing that stays closes any of it: land, depths, zones and icebergs that stand, ice of no end.
  [[nodiscard]] bool is_open() const { return is_open_; }
  /// Whether the vehicle can keep to it then: everywhere the current is known and at most `hold_share` of its speed,
  /// and there is room below the ice.
  [[nodiscard]] bool is_kept(core::Seconds time) const;
  /// Whether it can at every time at which the currents are known, without a look at each.
  [[nodiscard]] bool is_always_kept() const;
  /// When something that closes for a while, a zone or an iceberg, touches it: ascending, apart from each other.
  [[nodiscard]] std::vector<TimeSpan> closed_times() const;
  [[nodiscard]] bool is_below_ice() const { return is_below_ice_; }

 private:
  const Sea& sea_;
  geo::PlanePoint centre_;
  bool is_below_ice_;  // at some time
  core::Metres radius_;
  std::array<geo::PlanePoint, 5> looks_;
  bool is_open_;
};

/// Of its speed through water: the strongest current in which a vehicle can hold.
/// A judgement: what is left of the speed brings it back to the centre.
inline constexpr double hold_share = 0.8;

}  // namespace floeplan::planning::cost

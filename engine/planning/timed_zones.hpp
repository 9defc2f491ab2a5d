#pragma once

#include <vector>

#include "engine/core/units.hpp"
#include "engine/motion/edge_time.hpp"
#include "engine/ocean/zone.hpp"
#include "engine/planning/plane_polygon.hpp"
#include "engine/planning/time_span.hpp"

namespace floeplan::planning {

/// Zones whose rule is in force for a while, tested along the drive itself, not at sample points.
/// Time     counted from `epoch`
/// Threads  const members may be called from several threads at once
class TimedZones {
 public:
  TimedZones(const std::vector<ocean::Zone>& zones, const geo::LocalProjection& projection,
             core::UtcTime epoch);

  [[nodiscard]] bool empty() const { return no_go_.empty() && stay_in_.empty(); }
  /// Whether a vehicle that drives this piece of the edge breaks a rule on it.
  [[nodiscard]] bool forbid(const motion::PlaneEdge& edge, const motion::EdgePiece& piece) const;
  /// Whether a vehicle that goes straight and evenly from a to b, or stands still, breaks a rule meanwhile.
  [[nodiscard]] bool forbid(geo::PlanePoint a, geo::PlanePoint b, TimeSpan during) const;
  /// When nobody may be at the point: ascending, apart from each other; infinite ends where the rule has none.
  [[nodiscard]] std::vector<TimeSpan> closed_times(geo::PlanePoint point) const;

 private:
  struct Area {
    PlanePolygon polygon;
    TimeSpan in_force;
  };
  template <class PlaceAt>
  [[nodiscard]] bool forbid_during(TimeSpan during, const PlaceAt& place_at) const;

  std::vector<Area> no_go_;
  std::vector<Area> stay_in_;
  std::vector<double> changes_s_;  // when the set of stay-in zones in force changes, ascending
};

}  // namespace floeplan::planning

#pragma once

#include <optional>
#include <vector>

#include "engine/motion/edge_piece.hpp"
#include "engine/planning/obstacles/iceberg_discs.hpp"
#include "engine/planning/obstacles/safety_map.hpp"
#include "engine/planning/obstacles/timed_zones.hpp"

namespace floeplan::planning::obstacles {

/// The places of the plane that are closed to a vehicle, and when. At all times: depth, land, standing zones,
/// standing icebergs. For a while: timed zones and moving icebergs. A view: it borrows its parts, which must
/// outlive it. Times count from the departure of the request.
/// Threads  const members may be called from several threads at once
class Closures {
 public:
  Closures(const SafetyMap& safety, const TimedZones& timed_zones, const IcebergDiscs& icebergs)
      : safety_{safety}, timed_zones_{timed_zones}, icebergs_{icebergs} {}

  /// The reason why the straight leg is closed at all times: depth, land, standing zones or standing icebergs. Empty
  /// when it is open.
  [[nodiscard]] std::optional<motion::EdgeClosed> closed_between(geo::PlanePoint a, geo::PlanePoint b) const {
    if (const auto closed = safety_.closed_between(a, b)) return closed;
    constexpr double at_any_time_s = 1.0;
    if (icebergs_.standing() && icebergs_.touched({a, b, 0.0, at_any_time_s}))
      return motion::EdgeClosed::obstacle;
    return std::nullopt;
  }
  /// True: every straight leg from the point that stays within `reach` along both axes is free of permanent
  /// closures. False: unknown.
  [[nodiscard]] bool open_about(geo::PlanePoint point, core::Metres reach) const {
    const bool may_stand = icebergs_.standing() && !icebergs_.empty();
    return !may_stand && safety_.open_about(point, reach);
  }
  /// Whether something is closed at some times only, so that a later arrival can be better.
  [[nodiscard]] bool any_timed() const { return !timed_zones_.empty() || !icebergs_.standing(); }
  /// Whether a timed zone or a moving iceberg closes a piece of a drive. The places of the piece may be wrong
  /// by `error_m`.
  [[nodiscard]] std::optional<motion::EdgeClosed> closed_during(const motion::PlaneEdge& edge,
                                                                const motion::EdgePiece& piece,
                                                                double error_m) const {
    if (timed_zones_.forbid(edge, piece)) return motion::EdgeClosed::in_zone;
    if (!icebergs_.standing() && icebergs_.touched(edge, piece, error_m)) return motion::EdgeClosed::obstacle;
    return std::nullopt;
  }
  /// When a timed zone or a moving iceberg closes the point: ascending, disjoint.
  [[nodiscard]] std::vector<TimeSpan> closed_times(geo::PlanePoint point) const;
  /// When a timed zone closes the point: ascending, disjoint.
  [[nodiscard]] std::vector<TimeSpan> closed_times_by_zones(geo::PlanePoint point) const {
    return timed_zones_.closed_times(point);
  }
  /// When a moving iceberg closes the point: ascending, disjoint. Its disc is enlarged by `grown` metres of
  /// the plane.
  [[nodiscard]] std::vector<TimeSpan> closed_times_by_icebergs(geo::PlanePoint point,
                                                               core::Metres grown = core::Metres{0.0}) const {
    return icebergs_.standing() ? std::vector<TimeSpan>{} : icebergs_.closed_times(point, grown);
  }
  /// The earliest departure between `depart` and `latest` at which no timed zone or moving iceberg blocks a
  /// vehicle that goes from a to b on a straight line at constant speed in `duration`. Empty if there is
  /// none.
  [[nodiscard]] std::optional<core::Seconds> first_clear_departure(geo::PlanePoint a, geo::PlanePoint b,
                                                                   core::Seconds duration,
                                                                   core::Seconds depart,
                                                                   core::Seconds latest) const;
  [[nodiscard]] const TimedZones& timed_zones() const { return timed_zones_; }

 private:
  const SafetyMap& safety_;
  const TimedZones& timed_zones_;
  const IcebergDiscs& icebergs_;
};

}  // namespace floeplan::planning::obstacles

#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/motion/edge_time.hpp"
#include "engine/ocean/zone.hpp"
#include "engine/planning/obstacles/disc_index.hpp"
#include "engine/planning/plane/plane_polygon.hpp"
#include "engine/planning/problem/time_span.hpp"

namespace floeplan::planning::obstacles {

/// What a way keeps from breaking a rule.
struct Room {
  core::Metres aside{0.0};  // metres of the plane
  core::Seconds time{0.0};  // earlier and later

  [[nodiscard]] bool is_none() const { return aside.value <= 0.0 && time.count() <= 0.0; }
};

/// Zones whose rule is in force for a while, tested along the drive itself, not at sample points.
/// Room     a drive must keep the rules also a little beside its way, to either side, a little earlier and later; so
///          must a vehicle that stands still, to all sides. Zones that overlap or touch count as one area
/// Time     counted from `epoch`
/// Threads  const members may be called from several threads at once
class TimedZones {
 public:
  /// `area`: where questions will be asked; the answers are right outside it too.
  TimedZones(const std::vector<ocean::Zone>& zones, const geo::LocalProjection& projection,
             const plane::PlaneBox& area, core::UtcTime epoch, Room room = {});

  [[nodiscard]] bool empty() const { return no_go_.empty() && stay_in_.empty(); }
  /// Whether a vehicle that drives this piece of the edge breaks a rule on it.
  [[nodiscard]] bool forbid(const motion::PlaneEdge& edge, const motion::EdgePiece& piece) const;
  /// Whether a vehicle that goes straight and evenly from a to b, or stands still, breaks a rule meanwhile.
  [[nodiscard]] bool forbid(geo::PlanePoint a, geo::PlanePoint b, TimeSpan during) const;
  /// When nobody may be at the point: ascending, apart from each other; infinite ends where the rule has none.
  [[nodiscard]] std::vector<TimeSpan> closed_times(geo::PlanePoint point) const;

 private:
  struct Area {
    plane::PlanePolygon polygon;
    TimeSpan in_force;
  };
  /// Zones of one kind, found by where they lie.
  class Areas {
   public:
    void add(Area area) { areas_.push_back(std::move(area)); }
    /// Once all are there.
    void index(const plane::PlaneBox& within);
    [[nodiscard]] bool empty() const { return areas_.empty(); }
    [[nodiscard]] const std::vector<Area>& all() const { return areas_; }
    /// Calls `visit(area)` for all that may meet the straight line from a to b, for some more than once; ends with true
    /// as soon as `visit` answers true.
    template <class Visit>
    bool any_near(geo::PlanePoint a, geo::PlanePoint b, const Visit& visit) const {
      plane::PlaneBox box{a, a};
      box.include(b);
      return index_.any_in(box, whenever, [&](std::uint32_t i) { return visit(areas_[i]); });
    }

   private:
    static constexpr TimeSpan whenever{};  // the index knows places only
    std::vector<Area> areas_;
    DiscIndex index_;
  };
  template <class PlaceAt>
  [[nodiscard]] bool breaks_rule(TimeSpan during, const PlaceAt& place_at) const;
  /// Whether any zone is so near that a way with room may break its rule though the way itself does not.
  [[nodiscard]] bool is_near(TimeSpan during, geo::PlanePoint a, geo::PlanePoint b) const;
  [[nodiscard]] std::vector<TimeSpan> closed_times_at(geo::PlanePoint point) const;
  template <class PlaceAt>
  [[nodiscard]] bool forbid_during(TimeSpan during, const PlaceAt& place_at) const;
  /// Whether the vehicle may only be inside some zone then.
  [[nodiscard]] bool confined_at(core::Seconds time) const;

  Room room_;
  Areas no_go_;
  Areas stay_in_;
  std::vector<double> changes_s_;   // when the set of stay-in zones in force changes, ascending
  std::vector<TimeSpan> confined_;  // when any stay-in zone is in force: ascending, apart from each other
};

}  // namespace floeplan::planning::obstacles

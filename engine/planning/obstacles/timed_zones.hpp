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

/// Extra distance and time that a route keeps from breaking a rule.
struct Room {
  core::Metres aside{0.0};  // on every side, metres of the plane
  core::Seconds time{0.0};  // before and after

  [[nodiscard]] bool is_none() const { return aside.value <= 0.0 && time.count() <= 0.0; }
};

/// Zones whose rule is in force for a while. They are tested along the whole drive, not at samples.
/// Room     the rules are also kept a little beside the drive, a little earlier and a little later. Zones
///          that overlap or touch count as one area
/// Time     counted from `epoch`
/// Threads  const members may be called from several threads at once
class TimedZones {
 public:
  /// `area`: where most questions will be asked; answers outside are right, too.
  TimedZones(const std::vector<ocean::Zone>& zones, const geo::LocalProjection& projection,
             const plane::PlaneBox& area, core::UtcTime epoch, Room room = {});

  [[nodiscard]] bool empty() const { return no_go_.empty() && stay_in_.empty(); }
  /// Whether a vehicle that travels this piece of the edge breaks a rule.
  [[nodiscard]] bool forbid(const motion::PlaneEdge& edge, const motion::EdgePiece& piece) const;
  /// Whether a vehicle that goes straight from a to b at constant speed, or stays in one place, breaks a
  /// rule.
  [[nodiscard]] bool forbid(geo::PlanePoint a, geo::PlanePoint b, TimeSpan during) const;
  /// When no vehicle may be at the point: ascending, disjoint; an end may be infinite.
  [[nodiscard]] std::vector<TimeSpan> closed_times(geo::PlanePoint point) const;

 private:
  struct Area {
    plane::PlanePolygon polygon;
    TimeSpan in_force;
  };
  /// Zones of one kind, with an index by place.
  class Areas {
   public:
    void add(Area area) { areas_.push_back(std::move(area)); }
    /// Builds the index. Call once after the last `add`.
    void index(const plane::PlaneBox& within);
    [[nodiscard]] bool empty() const { return areas_.empty(); }
    [[nodiscard]] const std::vector<Area>& all() const { return areas_; }
    /// Calls `visit(area)` for all zones that may meet the straight line from a to b, some of them more than
    /// once. Ends with true as soon as `visit` returns true.
    template <class Visit>
    bool any_near(geo::PlanePoint a, geo::PlanePoint b, const Visit& visit) const {
      plane::PlaneBox box{a, a};
      box.include(b);
      return index_.any_in(box, whenever, [&](std::uint32_t i) { return visit(areas_[i]); });
    }

   private:
    static constexpr TimeSpan whenever{};  // the index is by place only
    std::vector<Area> areas_;
    DiscIndex index_;
  };
  template <class PlaceAt>
  [[nodiscard]] bool breaks_rule(TimeSpan during, const PlaceAt& place_at) const;
  /// Whether a zone is so near that the room around the line may break its rule, although the line itself
  /// does not.
  [[nodiscard]] bool is_near(TimeSpan during, geo::PlanePoint a, geo::PlanePoint b) const;
  [[nodiscard]] std::vector<TimeSpan> closed_times_at(geo::PlanePoint point) const;
  template <class PlaceAt>
  [[nodiscard]] bool forbid_during(TimeSpan during, const PlaceAt& place_at) const;
  /// Whether a stay-in zone is in force at this time, so that the vehicle must be inside one.
  [[nodiscard]] bool confined_at(core::Seconds time) const;

  Room room_;
  Areas no_go_;
  Areas stay_in_;
  std::vector<double> changes_s_;   // when the set of stay-in zones in force changes, ascending
  std::vector<TimeSpan> confined_;  // when some stay-in zone is in force: ascending, disjoint
};

}  // namespace floeplan::planning::obstacles

#pragma once

#include <cmath>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include "engine/motion/edge_time.hpp"
#include "engine/ocean/environment.hpp"
#include "engine/planning/ice/ice_covers.hpp"
#include "engine/planning/obstacles/bed_cells.hpp"
#include "engine/planning/obstacles/marked_cells.hpp"
#include "engine/planning/problem/plan_request.hpp"

namespace floeplan::planning::ice {

/// Tells where and when a vehicle may surface, and where it may pass below the ice. These are two questions, because a
/// glider can pass below ice in which it cannot surface.
/// Rules    The vehicle may surface where the ice is known and at most as dense as the request allows. Under denser ice
///          its upper turn lies the margin below the deepest keel. Between that turn and the sea bed it needs as much
///          water as it otherwise needs below the surface, with room for a saw-tooth above the altimeter's margin, and
///          its dives must reach that depth. Where the ice is unknown the vehicle may pass below the keels that were
///          known last, and the plan counts on no surfacing
/// Depth    the least depth of the sea bed along the whole edge counts, so no sill between two samples is missed
/// Along a drive  the ice is sampled every `step()`; a step takes the deeper of the turns at its two ends. The time of
///          a step counts as under ice unless the vehicle may surface at both ends. So the counted time is never too
///          short, except for ice that is narrower than a step
/// Threads  const members may be called from several threads at once
class UnderIce {
 public:
  /// `cell`  size of a cell of the safety map; the ice is sampled at this spacing, or closer if its data are
  /// finer
  /// `bed`   sea bed of the whole area; null: the bed is not known, and no depth is checked
  /// `stop`  once it is requested this object stays incomplete and must not be used
  /// Precondition  `environment` has ice
  UnderIce(const ocean::Environment& environment, const PlanRequest& request,
           const geo::LocalProjection& projection, const plane::PlaneBox& area, core::Metres cell,
           std::shared_ptr<const obstacles::BedCells> bed, const std::stop_token& stop = {});

  [[nodiscard]] IceAbove above(geo::PlanePoint point, core::Seconds time) const {
    return cover_.above(point, time);
  }
  [[nodiscard]] bool may_surface(geo::PlanePoint point, core::Seconds time) const {
    return cover_.above(point, time).may_surface;
  }
  /// The upper turn that dives need at this place and time; zero if the vehicle may surface or no ice was
  /// ever known.
  [[nodiscard]] core::Metres least_upper_turn(geo::PlanePoint point, core::Seconds time) const;
  [[nodiscard]] bool may_transit(geo::PlanePoint point, core::Seconds time) const;
  /// Whether the vehicle may surface, and whether it may pass below the ice.
  struct Leave {
    bool to_surface{};
    bool to_transit{};
  };
  /// A lower bound of the distance in the plane to any place where the vehicle may surface at any time; infinite where
  /// there is no such place.
  [[nodiscard]] core::Metres least_way_to_opening(geo::PlanePoint point) const {
    return cover_.least_way_to_opening(point);
  }
  /// As `least_way_to_opening`, for each point, to places where the vehicle may surface at some time from
  /// `from` to `until`.
  [[nodiscard]] std::vector<core::Metres> least_ways_to_opening(const std::vector<geo::PlanePoint>& points,
                                                                core::Seconds from,
                                                                core::Seconds until) const {
    return cover_.least_ways_to_opening(points, from, until);
  }
  /// Whether there is ice anywhere, at any time, that the vehicle would have to pass below.
  [[nodiscard]] bool has_dense_ice() const { return cover_.has_dense_ice(); }
  /// A lower bound of the distance in the plane to any ice that the vehicle would have to pass below at any time.
  [[nodiscard]] core::Metres least_way_to_dense_ice(geo::PlanePoint point) const {
    return cover_.least_way_to_dense_ice(point);
  }
  /// The last step of the ice data.
  [[nodiscard]] core::Seconds last_step() const { return cover_.last_step(); }
  /// Whether the straight line from a to b may cross ice that the vehicle would have to pass below.
  [[nodiscard]] bool may_be_dense_along(geo::PlanePoint a, geo::PlanePoint b) const {
    return cover_.has_dense_ice() && cover_.least_way_to_dense_ice(a).value <= geo::distance_m(a, b);
  }
  /// Whether the ice may leave the vehicle no room below it somewhere on the straight line from a to b. Where
  /// not, no drive along it needs `may_transit_along`.
  [[nodiscard]] bool may_close(geo::PlanePoint a, geo::PlanePoint b) const {
    return tight_ ? tight_->may_meet(a, b) : may_be_dense_along(a, b);
  }
  /// Whether there is room below the ice all along a piece of a drive.
  [[nodiscard]] bool may_transit_along(const motion::PlaneEdge& edge, const motion::EdgePiece& piece) const;
  [[nodiscard]] core::Metres step() const { return core::Metres{step_m_}; }

  /// Without the bed, which others share.
  [[nodiscard]] std::size_t bytes() const { return cover_.bytes(); }

 private:
  friend class IceWatch;

  /// The cells of the bed in which there may be ice that leaves no room: dense ice is near, and the deepest keel of all
  /// would leave too little water. Empty where the depth of the dives or a bed that is not laid out decides.
  [[nodiscard]] std::optional<obstacles::MarkedCells> tight_cells() const;
  [[nodiscard]] core::Metres turn_below(const IceAbove& ice) const;
  /// Whether a dive has room below an upper turn at this depth; a turn of zero means that no ice is above.
  [[nodiscard]] bool has_room_below(core::Metres turn, geo::PlanePoint a, geo::PlanePoint b) const;

  UnderIceRules rules_;
  IceCovers cover_;
  std::shared_ptr<const obstacles::BedCells> bed_;  // null: no depth is checked, or there is no dense ice
  std::optional<obstacles::MarkedCells> tight_;     // of the bed's cells
  double needed_below_m_;                           // from the upper turn to the sea bed
  double dive_room_m_;                              // from the upper turn to the deepest point of the dives
  double dive_depth_m_;
  double step_m_;
};

/// Samples the ice along a drive, one place after the other.
class IceWatch {
 public:
  /// `ice` is borrowed.
  IceWatch(const UnderIce& ice, geo::PlanePoint start, core::Seconds time)
      : ice_{ice}, last_{start}, last_turn_{ice.least_upper_turn(start, time)} {}

  /// Takes the next sample: whether the vehicle may surface there, and whether there was room below the ice
  /// on the way there.
  [[nodiscard]] UnderIce::Leave look(geo::PlanePoint point, core::Seconds time);

 private:
  const UnderIce& ice_;
  geo::PlanePoint last_;
  core::Metres last_turn_;
};

}  // namespace floeplan::planning::ice

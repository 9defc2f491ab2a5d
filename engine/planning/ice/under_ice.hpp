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
#include "engine/planning/problem/plan_request.hpp"

namespace floeplan::planning::ice {

/// Where and when a vehicle may come to the surface, and where it may pass below the ice: two questions, because a
/// glider can pass under ice that it cannot pass through.
/// Rules    it may surface where the ice is known and at most as dense as the request allows. Under denser ice its
///          upper turn stays the margin below the deepest keel, and it needs as much water from there to the sea bed
///          as it otherwise needs from the surface, with room for a saw-tooth above the altimeter's margin; its dives
///          must reach that deep. Where nothing is known of the ice it may pass, below the keels that were known last,
///          but not count on surfacing
/// Depth    that of the bed all along a way: no sill between two looks is missed
/// Along a drive  looked at every `step()`, with the deeper of the turns at both ends of a step; the time between two
///          looks counts as under ice unless the vehicle may surface at both, so that what counts is never shorter
///          than the truth but for ice narrower than a step
/// Threads  const members may be called from several threads at once
class UnderIce {
 public:
  /// `cell`  of the safety map; the ice is looked at as closely, or closer where its own data are finer. Once `stop`
  /// is requested it stays incomplete and must not be used. `environment` must have ice. `bed`  of all the area; null:
  /// it is laid out here, where there is bathymetry
  UnderIce(const ocean::Environment& environment, const PlanRequest& request,
           const geo::LocalProjection& projection, const plane::PlaneBox& area, core::Metres cell,
           const std::stop_token& stop = {}, std::shared_ptr<const obstacles::BedCells> bed = nullptr);

  [[nodiscard]] IceAbove above(geo::PlanePoint point, core::Seconds time) const {
    return cover_.above(point, time);
  }
  [[nodiscard]] bool may_surface(geo::PlanePoint point, core::Seconds time) const {
    return cover_.above(point, time).may_surface;
  }
  /// How deep the upper turn of the dives must lie there and then; zero where the vehicle may surface, or where
  /// no ice was ever known.
  [[nodiscard]] core::Metres least_upper_turn(geo::PlanePoint point, core::Seconds time) const;
  [[nodiscard]] bool may_transit(geo::PlanePoint point, core::Seconds time) const;
  /// Both questions at once.
  struct Leave {
    bool to_surface{};
    bool to_transit{};
  };
  /// Never more than the way in the plane to where the vehicle may surface, at whatever time; infinite where that is
  /// nowhere.
  [[nodiscard]] core::Metres least_way_to_opening(geo::PlanePoint point) const {
    return cover_.least_way_to_opening(point);
  }
  /// The same for each point, to where it may surface at some time between these two.
  [[nodiscard]] std::vector<core::Metres> least_ways_to_opening(const std::vector<geo::PlanePoint>& points,
                                                                core::Seconds from,
                                                                core::Seconds until) const {
    return cover_.least_ways_to_opening(points, from, until);
  }
  /// Whether there is ice anywhere, at any time, that the vehicle would have to pass below.
  [[nodiscard]] bool has_dense_ice() const { return cover_.has_dense_ice(); }
  /// Never more than the way in the plane to ice that the vehicle would have to pass below, at whatever time.
  [[nodiscard]] core::Metres least_way_to_dense_ice(geo::PlanePoint point) const {
    return cover_.least_way_to_dense_ice(point);
  }
  /// Of the data of the ice.
  [[nodiscard]] core::Seconds last_step() const { return cover_.last_step(); }
  /// Whether there may be ice on a line that the vehicle would have to pass below.
  [[nodiscard]] bool may_be_dense_along(geo::PlanePoint a, geo::PlanePoint b) const {
    return cover_.has_dense_ice() && cover_.least_way_to_dense_ice(a).value <= geo::distance_m(a, b);
  }
  /// Whether there is room below the ice all along a piece of a drive.
  [[nodiscard]] bool may_transit_along(const motion::PlaneEdge& edge, const motion::EdgePiece& piece) const;
  [[nodiscard]] core::Metres step() const { return core::Metres{step_m_}; }

  [[nodiscard]] std::size_t bytes() const { return cover_.bytes() + (bed_ ? bed_->bytes() : 0); }

 private:
  friend class IceWatch;

  [[nodiscard]] core::Metres turn_below(const IceAbove& ice) const;
  /// Whether a turn at this depth leaves room for a dive; zero: nothing is in the way above.
  [[nodiscard]] bool has_room_below(core::Metres turn, geo::PlanePoint a, geo::PlanePoint b) const;

  UnderIceRules rules_;
  IceCovers cover_;
  std::shared_ptr<const obstacles::BedCells> bed_;  // null: every depth will do
  double needed_below_m_;                           // from the upper turn to the sea bed
  double dive_room_m_;                              // from the upper turn to the deepest point of the dives
  double dive_depth_m_;
  double step_m_;
};

/// Looks at what is above along a drive, one place after the other.
class IceWatch {
 public:
  /// `ice` is borrowed.
  IceWatch(const UnderIce& ice, geo::PlanePoint start, core::Seconds time)
      : ice_{ice}, last_{start}, last_turn_{ice.least_upper_turn(start, time)} {}

  /// The next look: whether the vehicle may surface there, and whether there is room for it on the way to there.
  [[nodiscard]] UnderIce::Leave look(geo::PlanePoint point, core::Seconds time);

 private:
  const UnderIce& ice_;
  geo::PlanePoint last_;
  core::Metres last_turn_;
};

}  // namespace floeplan::planning::ice

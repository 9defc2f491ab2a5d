#pragma once

#include <optional>
#include <stop_token>
#include <vector>

#include "engine/motion/edge_time.hpp"
#include "engine/ocean/environment.hpp"
#include "engine/planning/ice_cover.hpp"
#include "engine/planning/plan_request.hpp"
#include "engine/planning/plane_bed.hpp"

namespace floeplan::planning {

/// Where and when a vehicle may come to the surface, and where it may pass below the ice: two questions, because a
/// glider can pass under ice that it cannot pass through.
/// Rules    it may surface where the ice is known and at most as dense as the request allows. Under denser ice its
///          upper turn stays the margin below the deepest keel, and it needs as much water from there to the sea bed
///          as it otherwise needs from the surface; its dives must reach that deep. Where nothing is known of the
///          ice it may pass, but not count on surfacing
/// Along a drive  looked at every `step()`; the time between two looks counts as under ice unless the vehicle may
///          surface at both, so that what counts is never shorter than the truth but for ice narrower than a step
/// Threads  const members may be called from several threads at once
class UnderIce {
 public:
  /// Once `stop` is requested it stays incomplete and must not be used. `environment` must have ice.
  UnderIce(const ocean::Environment& environment, const PlanRequest& request,
           const geo::LocalProjection& projection, const PlaneBox& area, core::Metres step,
           const std::stop_token& stop = {});

  [[nodiscard]] IceAbove above(geo::PlanePoint point, core::Seconds time) const {
    return cover_.above(point, time);
  }
  [[nodiscard]] bool may_surface(geo::PlanePoint point, core::Seconds time) const {
    return cover_.above(point, time).may_surface;
  }
  /// How deep the upper turn of the dives must lie there and then; zero where the vehicle may surface, or where
  /// nothing is known.
  [[nodiscard]] core::Metres least_upper_turn(geo::PlanePoint point, core::Seconds time) const;
  [[nodiscard]] bool may_transit(geo::PlanePoint point, core::Seconds time) const;
  /// Whether there is ice at all that the vehicle would have to pass below.
  [[nodiscard]] bool has_dense_ice() const { return cover_.has_dense_ice(); }
  /// Whether there is room below the ice all along a piece of a drive.
  [[nodiscard]] bool may_transit_along(const motion::PlaneEdge& edge, const motion::EdgePiece& piece) const;
  [[nodiscard]] std::optional<core::Seconds> longest_without_surfacing() const {
    return rules_.max_time_without_surfacing;
  }

  [[nodiscard]] core::Metres step() const { return core::Metres{step_m_}; }

 private:
  [[nodiscard]] bool has_room_below(geo::PlanePoint point, const IceAbove& ice) const;

  UnderIceRules rules_;
  IceCover cover_;
  std::optional<PlaneBed> bed_;  // empty: every depth will do
  double needed_below_m_;        // from the upper turn to the sea bed
  double dive_room_m_;           // from the upper turn to the deepest point of the dives
  double dive_depth_m_;
  double step_m_;
};

/// Watches a drive for ice: closes it where there is no room below the ice, and where the last possible surfacing
/// lies too far back. A visitor of the pieces of an edge.
class IceWatch {
 public:
  IceWatch(const UnderIce& ice, const motion::PlaneEdge& edge, core::Seconds since_surfacing)
      : ice_{ice}, edge_{edge}, since_s_{since_surfacing.count()} {}

  std::optional<motion::EdgeClosed> operator()(const motion::EdgePiece& piece);
  [[nodiscard]] core::Seconds since_surfacing() const { return core::Seconds{since_s_}; }

 private:
  const UnderIce& ice_;
  const motion::PlaneEdge& edge_;
  double since_s_;
};

}  // namespace floeplan::planning

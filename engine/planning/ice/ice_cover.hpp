#pragma once

#include <cstddef>
#include <optional>
#include <stop_token>
#include <vector>

#include "engine/ocean/ice/ice_field.hpp"
#include "engine/planning/obstacles/cell_distances.hpp"
#include "engine/planning/plane/plane_grid.hpp"
#include "engine/planning/problem/under_ice_rules.hpp"

namespace floeplan::planning::ice {

/// The ice above a vehicle at one place and time.
struct IceAbove {
  bool known{false};        // the data cover this place and time
  bool may_surface{false};  // the ice is known, and no denser than the request allows
  double draft_m{};         // of the deepest keel; 0 if the vehicle may surface or ice was never known
};

/// The sea ice of a planning area at the time of passage, prepared for the inner loop of a search.
/// Interpolation  concentration: bilinear between the nodes of the data and linear between their times.
///                Draft: the deepest of the surrounding nodes and times
/// Coast    a node without data takes the most ice of its neighbours, one ring deep, because land masks are
///          coarse
/// Time     counted from `epoch`; ocean::ice_moment says which steps of the data count for a time
/// Outside  the ice is unknown beyond the nodes with data and their ring, before and after the period of the
///          data, and in its long gaps. Dives then keep below the keels of dense ice that were known last,
///          because missing data are no evidence that the ice has gone
/// Threads  const members may be called from several threads at once
class IceCover {
 public:
  /// Once `stop` is requested the cover stays incomplete and must not be used.
  IceCover(const ocean::IceField& ice, const UnderIceRules& rules, const geo::LocalProjection& projection,
           const plane::PlaneBox& area, core::UtcTime epoch, const std::stop_token& stop = {});

  [[nodiscard]] IceAbove above(geo::PlanePoint point, core::Seconds time) const;
  /// The steps of the data that count for `time`.
  [[nodiscard]] ocean::IceMoment moment(core::Seconds time) const {
    return ocean::ice_moment(times_s_, time.count());
  }
  /// Whether the ice above comes from a node without data, which took the ice of its neighbours.
  [[nodiscard]] bool is_extended(geo::PlanePoint point, core::Seconds time) const;
  /// The keels above a place.
  struct Keels {
    double told_m{};      // deepest draft by the thickness in the data
    bool all_told{true};  // no draft there had to be assumed
  };
  [[nodiscard]] Keels keels(geo::PlanePoint point, core::Seconds time) const;
  /// First step of the data.
  [[nodiscard]] core::Seconds first_step() const { return core::Seconds{times_s_.front()}; }
  /// Whether there is ice anywhere, at any time, through which the vehicle may not surface.
  [[nodiscard]] bool has_dense_ice() const { return has_dense_ice_; }
  /// The deepest draft of all keels, at any place and time.
  [[nodiscard]] core::Metres deepest_draft() const { return deepest_draft_; }
  /// A lower bound of the distance in the plane to any place where the vehicle may surface at any time. Zero beyond the
  /// nodes; infinite where there is no such place.
  [[nodiscard]] core::Metres least_way_to_opening(geo::PlanePoint point) const;
  /// As `least_way_to_opening`, for each point, to places where the vehicle may surface at some time from
  /// `from` to `until`.
  [[nodiscard]] std::vector<core::Metres> least_ways_to_opening(const std::vector<geo::PlanePoint>& points,
                                                                core::Seconds from,
                                                                core::Seconds until) const;
  /// A lower bound of the distance in the plane to any ice through which the vehicle may not surface at any time.
  [[nodiscard]] core::Metres least_way_to_dense_ice(geo::PlanePoint point) const;
  /// Last step of the data.
  [[nodiscard]] core::Seconds last_step() const { return core::Seconds{times_s_.back()}; }
  /// Distance between the data's nodes.
  [[nodiscard]] core::Metres spacing() const { return spacing_; }

  [[nodiscard]] std::size_t bytes() const {
    return nodes_.size() * sizeof(Node) + to_openings_.bytes() + to_dense_ice_.bytes();
  }

 private:
  struct Node {
    float concentration;  // NaN: unknown
    float draft_m;        // of its keels; if unknown, of the last known dense ice, or 0
  };
  [[nodiscard]] bool is_dense(const Node& node) const;
  void keep_last_keels();
  void extend_to_coast();
  /// Distances to the cells that have at least one marked node.
  [[nodiscard]] obstacles::CellDistances distances_to(const std::vector<bool>& marked_nodes) const;
  void measure_distances();

  plane::PlaneGrid grid_;
  std::vector<double> times_s_;  // since epoch
  std::vector<Node> nodes_;      // [time][y][x]
  std::vector<bool> assumed_;    // [time][y][x], whether the draft of the node is assumed
  std::vector<bool> extended_;   // [time][y][x], whether the node took the ice of its neighbours
  double limit_;
  bool has_dense_ice_{false};
  core::Metres deepest_draft_;
  core::Metres spacing_;
  obstacles::CellDistances to_openings_;
  obstacles::CellDistances to_dense_ice_;
};

}  // namespace floeplan::planning::ice

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

/// What is above a vehicle.
struct IceAbove {
  bool known{false};        // the data tell of the ice here and now
  bool may_surface{false};  // they do, and it is little enough
  double draft_m{};         // of the deepest keel; 0 where the vehicle may surface or nothing was ever known
};

/// The sea ice of a planning area at the time of passage: what the inner loop asks.
/// Interpolation  concentration as the data's own: bilinear between its nodes, linear between its times; the draft is
///                the deepest of the nodes and times around
/// Coast    a node without data takes the most ice of its neighbours, one ring deep: masks of land are coarse
/// Time     counted from `epoch`; which steps count for it is what ocean::ice_moment says
/// Outside  nothing known beyond the nodes with data (and that ring), before and after the period and in long gaps of
///          it. Keels below dense ice that were known last, at a node or in all, stay to be kept below: that nobody
///          looked for them since lifts none
/// Threads  const members may be called from several threads at once
class IceCover {
 public:
  /// Once `stop` is requested the cover stays incomplete and must not be used.
  IceCover(const ocean::IceField& ice, const UnderIceRules& rules, const geo::LocalProjection& projection,
           const plane::PlaneBox& area, core::UtcTime epoch, const std::stop_token& stop = {});

  [[nodiscard]] IceAbove above(geo::PlanePoint point, core::Seconds time) const;
  /// What the data tell of this time.
  [[nodiscard]] ocean::IceMoment moment(core::Seconds time) const {
    return ocean::ice_moment(times_s_, time.count());
  }
  /// Whether what is above rests on a node without data that took those of its neighbours.
  [[nodiscard]] bool is_extended(geo::PlanePoint point, core::Seconds time) const;
  /// Of what is above.
  struct Keels {
    double told_m{};      // the deepest by the thickness that the data tell
    bool all_told{true};  // none is assumed
  };
  [[nodiscard]] Keels keels(geo::PlanePoint point, core::Seconds time) const;
  /// First step of the data.
  [[nodiscard]] core::Seconds first_step() const { return core::Seconds{times_s_.front()}; }
  /// Whether there is ice anywhere, at any time, through which the vehicle may not surface.
  [[nodiscard]] bool has_dense_ice() const { return has_dense_ice_; }
  /// Never more than the way in the plane to where the vehicle may surface, at whatever time; zero beyond the nodes.
  /// Infinite where that is nowhere.
  [[nodiscard]] core::Metres least_way_to_opening(geo::PlanePoint point) const;
  /// The same for each point, to where it may surface at some time between these two.
  [[nodiscard]] std::vector<core::Metres> least_ways_to_opening(const std::vector<geo::PlanePoint>& points,
                                                                core::Seconds from,
                                                                core::Seconds until) const;
  /// The same as the first to ice through which it may not surface.
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
    float concentration;  // NaN where nothing is known
    float draft_m;        // of its keels; there of the dense ice that was known last, 0 for none
  };
  [[nodiscard]] bool is_dense(const Node& node) const;
  void keep_last_keels();
  void extend_to_coast();
  /// To cells of which a node is marked, whatever the rest of it is.
  [[nodiscard]] obstacles::CellDistances distances_to(const std::vector<bool>& marked_nodes) const;
  void measure_distances();

  plane::PlaneGrid grid_;
  std::vector<double> times_s_;  // since epoch
  std::vector<Node> nodes_;      // [time][y][x]
  std::vector<bool> assumed_;    // [time][y][x], whether its draft is
  std::vector<bool> extended_;   // [time][y][x]
  double limit_;
  bool has_dense_ice_{false};
  core::Metres spacing_;
  obstacles::CellDistances to_openings_;
  obstacles::CellDistances to_dense_ice_;
};

}  // namespace floeplan::planning::ice

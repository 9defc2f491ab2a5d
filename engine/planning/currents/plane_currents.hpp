#pragma once

#include <cstddef>
#include <optional>
#include <stop_token>
#include <vector>

#include "engine/motion/plane_current.hpp"
#include "engine/motion/plane_edge.hpp"
#include "engine/ocean/currents/current_grid.hpp"
#include "engine/planning/currents/flown_depths.hpp"
#include "engine/planning/plane/fast_axis.hpp"
#include "engine/planning/plane/grid_lookup.hpp"
#include "engine/planning/plane/node_window.hpp"
#include "engine/planning/plane/plane_box.hpp"

namespace floeplan::planning::ice {
class UnderIce;
}

namespace floeplan::planning::currents {

class CurrentLine;
struct NodeTurn;
class UpperTurns;

/// The currents of a planning area, averaged over the depths that the glider flies at each place, along the
/// axes of the plane. A steady saw-tooth spends the same time at every depth of its band, so the mean over
/// depth is the mean over time.
/// Depths   each column of the data is averaged over the band that is flown at the place asked for, not at
///          the column's own place. So a bank inside a cell of the data changes the current there. Where the
///          bands differ, cells are divided by `cut_cells`; in between, linear
/// Ice      under ice through which the vehicle may not surface, the band begins at the upper turn needed
///          there at that time, taken at the nearest node of the data; in steady currents at `epoch`
///          Interpolation as the data: bilinear between nodes, linear between times
/// Coast    a node without water takes the mean of its neighbours with water, one ring deep, because a
///          model's land mask is coarser than the coast; `is_extended` tells where
/// Time     counted from `epoch`; steady currents are valid at every time
/// Outside  empty beyond the nodes with water (and that ring) and beyond the data's period
/// Threads  const members may be called from several threads at once
class PlaneCurrents {
 public:
  /// Once `stop` is requested the currents stay incomplete and must not be used. `ice`: null without ice
  /// data.
  PlaneCurrents(const ocean::CurrentGrid& currents, bool steady, const FlownDepths& depths,
                const geo::LocalProjection& projection, const plane::PlaneBox& area, core::UtcTime epoch,
                const std::stop_token& stop = {}, const ice::UnderIce* ice = nullptr);

  [[nodiscard]] std::optional<motion::CurrentXy> operator()(geo::PlanePoint point, core::Seconds time) const;
  /// The current along an edge, cell by cell. Callers must also include current_line.hpp. Precondition:
  /// `has_lines()`.
  [[nodiscard]] CurrentLine line(const motion::PlaneEdge& edge) const;
  /// Whether `line` may be used: false if the data's longitudes jump inside the area.
  [[nodiscard]] bool has_lines() const { return !lookup_.has_jump(); }
  /// Whether the current at this point uses a node without water of its own (see Coast).
  [[nodiscard]] bool is_extended(geo::PlanePoint point) const;

  [[nodiscard]] core::MetresPerSecond strongest() const { return strongest_; }
  /// Distance between the nodes: the scale on which the current changes.
  [[nodiscard]] core::Metres spacing() const { return spacing_; }
  /// Shortest time between two steps of the data; empty if there is only one step.
  [[nodiscard]] std::optional<core::Seconds> time_step() const;
  /// The first step of the data after `time`; infinite if there is none.
  [[nodiscard]] core::Seconds next_step(core::Seconds time) const;
  [[nodiscard]] std::size_t bytes() const { return nodes_.size() * sizeof(Node) + extended_.size(); }
  /// Last time with data; empty if steady.
  [[nodiscard]] std::optional<core::Seconds> end() const;

 private:
  friend class CurrentEnvelope;
  friend class CurrentLine;
  friend class NearbyCurrents;

  struct Corner {
    std::size_t first;  // index of the south-western node
    double fx;
    double fy;
  };
  struct Node {
    float x_m_s;
    float y_m_s;
  };
  [[nodiscard]] std::optional<Corner> corner(geo::PlanePoint point) const;
  void fill(const ocean::CurrentGrid& currents, const plane::NodeWindow& window, int parts,
            const std::vector<vehicle::DiveBand>& bands, const UpperTurns& upper_turns,
            const std::vector<NodeTurn>& turns, const std::stop_token& stop);

  plane::GridLookup lookup_;
  plane::FastAxis x_;  // of the data's window, divided; longitudes run on across the data's seam
  plane::FastAxis y_;
  std::optional<plane::FastAxis> times_s_;  // since epoch; empty: steady
  std::vector<Node> nodes_;                 // [time][y][x]; NaN: no water
  std::vector<std::uint8_t> extended_;      // [y][x]
  core::MetresPerSecond strongest_{};
  core::Metres spacing_{};
  double straight_parts_per_metre_{};  // of a line: parts that count as straight in the data's coordinates
};

}  // namespace floeplan::planning::currents

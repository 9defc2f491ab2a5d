#pragma once

#include <cstdint>
#include <optional>
#include <stop_token>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/geo/local_projection.hpp"
#include "engine/motion/edge_closed.hpp"
#include "engine/ocean/environment.hpp"
#include "engine/planning/plane_box.hpp"

namespace floeplan::planning {

/// Where the water is deep enough, as a raster over the plane. A cell is closed when any part of it that the
/// data know of is: its corners, the nodes of the bathymetry inside it, a coast that runs through it.
/// Cautious by up to one cell.
/// Edges    bathymetry given but not known in a cell: closed (outside_data). No bathymetry: every depth will
///          do
/// Threads  const members may be called from several threads at once
class SafetyMap {
 public:
  /// Once `stop` is requested the map stays incomplete and must not be used.
  SafetyMap(const ocean::Environment& environment, core::Metres least_depth,
            const geo::LocalProjection& projection, const PlaneBox& area, core::Metres cell,
            const std::stop_token& stop = {});

  /// Why the straight line from a to b is closed, by the first closed cell on it; empty when it is open.
  [[nodiscard]] std::optional<motion::EdgeClosed> closed_between(geo::PlanePoint a, geo::PlanePoint b) const;
  /// Why a place is closed by the data themselves, not by its cell; empty when it is open.
  [[nodiscard]] std::optional<motion::EdgeClosed> closed_at(geo::LonLat place) const;
  /// Opens the cell of a place that is open itself, so that caution about the rest of the cell does not lock
  /// it in.
  void open_around(geo::PlanePoint point);

 private:
  enum class Cell : std::uint8_t { open, too_shallow, on_land, outside_data };

  [[nodiscard]] std::optional<std::size_t> index(geo::PlanePoint point) const;
  void close_shallow_cells(const std::stop_token& stop);
  void close_land_cells(const std::vector<geo::Polygon>& land, const std::stop_token& stop);
  void close_along(geo::PlanePoint a, geo::PlanePoint b);
  void measure_clearance(const std::stop_token& stop);
  template <class Visit>
  void for_each_cell(geo::PlanePoint a, geo::PlanePoint b, Visit&& visit) const;

  const ocean::Environment* environment_;  // borrowed; outlives the map
  core::Metres least_depth_;
  geo::LocalProjection projection_;
  PlaneBox area_;
  double cell_m_;
  std::int64_t nx_;
  std::int64_t ny_;
  std::vector<Cell> cells_;  // [y][x]
  std::vector<std::uint8_t>
      clearance_;  // cells in every direction that are open, 0 on a closed one, at most 255
};

}  // namespace floeplan::planning

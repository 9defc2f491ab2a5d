#pragma once

#include <cstdint>
#include <optional>
#include <stop_token>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/geo/bounding_box.hpp"
#include "engine/geo/local_projection.hpp"
#include "engine/motion/edge_closed.hpp"
#include "engine/ocean/environment.hpp"
#include "engine/planning/plane/plane_raster.hpp"

namespace floeplan::planning::obstacles {

/// Whether a vehicle may be in a cell of the safety map, and if not, why.
enum class CellState : std::uint8_t { open, too_shallow, on_land, outside_data, in_zone };

/// Areas with a rule that is always in force.
struct StandingZones {
  std::vector<geo::Polygon> no_go;
  std::vector<geo::Polygon> stay_in;
  bool confined{false};  // the vehicle must stay in one of `stay_in`, also when there is none
};

/// Where the water is deep enough and the rules allow it, as a raster over the plane. A cell is closed when any part of
/// it that the data know of is: its corners, the nodes of the bathymetry inside it, a coast or a zone's border that
/// runs through it. Stay-in zones that overlap or touch count as one area.
/// Cautious by up to one cell.
/// Edges    bathymetry given but not known in a cell: closed (outside_data). No bathymetry: every depth will
///          do
/// Threads  const members may be called from several threads at once
class SafetyMap {
 public:
  /// Once `stop` is requested the map stays incomplete and must not be used.
  SafetyMap(const ocean::Environment& environment, core::Metres least_depth, StandingZones zones,
            const geo::LocalProjection& projection, const plane::PlaneBox& area, core::Metres cell,
            const std::stop_token& stop = {});

  /// Why the straight line from a to b is closed, by the first closed cell on it; empty when it is open.
  [[nodiscard]] std::optional<motion::EdgeClosed> closed_between(geo::PlanePoint a, geo::PlanePoint b) const;
  /// Whether every straight line from a point of the map that goes no further than `reach` along either axis is open:
  /// certainly so when true.
  [[nodiscard]] bool open_about(geo::PlanePoint point, core::Metres reach) const;
  /// Why a place is closed by the data themselves, not by its cell; empty when it is open.
  [[nodiscard]] std::optional<motion::EdgeClosed> closed_at(geo::LonLat place) const;
  [[nodiscard]] core::Metres cell() const { return core::Metres{raster_.cell_m()}; }
  [[nodiscard]] std::size_t bytes() const;
  /// Opens the cell of a place that is open itself, so that caution about the rest of the cell does not lock
  /// it in.
  void open_around(geo::PlanePoint point);
  /// Opens the cells of given routes that are closed out of caution alone: those of legs of which the data
  /// themselves close no part, looked up every 25 m. So a route is judged by where it runs, not by how cells
  /// happen to fall round it. A cell that a closed leg crosses too stays closed.
  void open_along(const std::vector<std::vector<geo::PlanePoint>>& routes,
                  const geo::LocalProjection& projection);

 private:
  [[nodiscard]] bool is_on_land(geo::LonLat place) const;
  void close_cells(const geo::Polygon& polygon, CellState state, const geo::LocalProjection& projection);
  void close_zones(const geo::LocalProjection& projection, const std::stop_token& stop);
  [[nodiscard]] std::vector<std::size_t> closed_cells_between(geo::PlanePoint a, geo::PlanePoint b) const;
  /// Whether the data close a part of the line that lies in one of these cells, which are sorted.
  [[nodiscard]] bool closed_within(const std::vector<std::size_t>& cells, geo::PlanePoint a,
                                   geo::PlanePoint b, const geo::LocalProjection& projection) const;
  void measure_clearance(const std::stop_token& stop);

  const ocean::Environment* environment_;  // borrowed; outlives the map
  core::Metres least_depth_;
  StandingZones zones_;
  plane::PlaneRaster raster_;
  geo::BoundingBox detailed_;       // the raster, and a little more
  std::vector<geo::Polygon> land_;  // the environment's, as good as that in the box
  std::vector<CellState> cells_;
  std::vector<std::uint8_t>
      clearance_;  // cells in every direction that are open, 0 on a closed one, at most 255
};

}  // namespace floeplan::planning::obstacles

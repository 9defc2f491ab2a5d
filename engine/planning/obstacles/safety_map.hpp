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
#include "engine/planning/obstacles/bed_cells.hpp"
#include "engine/planning/plane/plane_raster.hpp"

namespace floeplan::planning::obstacles {

/// Whether a vehicle may be in a cell of the safety map, and if not, why.
enum class CellState : std::uint8_t { open, too_shallow, on_land, outside_data, in_zone };

/// Areas with a rule that is always in force.
struct StandingZones {
  std::vector<geo::Polygon> no_go;
  std::vector<geo::Polygon> stay_in;
  bool confined{false};  // the vehicle must stay in one of `stay_in`; if that is empty, everything is closed
};

/// Where the water is deep enough and the rules allow the vehicle, as a raster over the plane. A cell is
/// closed if any part of it is closed in the data: its corners, the nodes of the bathymetry in it, a coast or
/// a zone's border that crosses it. So the map is cautious by up to one cell. Stay-in zones that overlap or
/// touch count as one area.
/// Edges    with bathymetry, a cell with unknown depth is closed (outside_data). Without bathymetry every
///          depth counts as deep enough
/// Threads  const members may be called from several threads at once
class SafetyMap {
 public:
  /// `bed`: the sea bed on the same raster, needed only during construction, or null: the map finds the least
  /// depths itself. The map is the same with both. Once `stop` is requested the map stays incomplete and must
  /// not be used.
  SafetyMap(const ocean::Environment& environment, core::Metres least_depth, StandingZones zones,
            const geo::LocalProjection& projection, const plane::PlaneBox& area, core::Metres cell,
            const BedCells* bed = nullptr, const std::stop_token& stop = {});

  /// The reason of the first closed cell on the straight line from a to b; empty if the line is open.
  [[nodiscard]] std::optional<motion::EdgeClosed> closed_between(geo::PlanePoint a, geo::PlanePoint b) const;
  /// True: every straight line from the point that stays within `reach` along both axes is open. False:
  /// unknown.
  [[nodiscard]] bool open_about(geo::PlanePoint point, core::Metres reach) const;
  /// The reason why the data themselves close a place, whatever its cell; empty if it is open.
  [[nodiscard]] std::optional<motion::EdgeClosed> closed_at(geo::LonLat place) const;
  [[nodiscard]] core::Metres cell() const { return core::Metres{raster_.cell_m()}; }
  [[nodiscard]] std::size_t bytes() const;
  /// Opens the cell of a place that is open in the data, although other parts of the cell are closed.
  /// Otherwise the vehicle could not leave its start.
  void open_around(geo::PlanePoint point);
  /// Opens closed cells along given routes, if the data themselves close no part of the leg in them (sampled
  /// every 25 m). So a route is judged by its own line and not by the raster. A cell that a closed leg also
  /// crosses stays closed.
  void open_along(const std::vector<std::vector<geo::PlanePoint>>& routes,
                  const geo::LocalProjection& projection);

 private:
  [[nodiscard]] bool is_on_land(geo::LonLat place) const;
  void close_cells(const geo::Polygon& polygon, CellState state, const geo::LocalProjection& projection);
  void close_zones(const geo::LocalProjection& projection, const std::stop_token& stop);
  [[nodiscard]] std::vector<std::size_t> closed_cells_between(geo::PlanePoint a, geo::PlanePoint b) const;
  /// Whether the data close some part of the line that lies in one of these cells, which must be sorted.
  [[nodiscard]] bool closed_within(const std::vector<std::size_t>& cells, geo::PlanePoint a,
                                   geo::PlanePoint b, const geo::LocalProjection& projection) const;
  void measure_clearance(const std::stop_token& stop);

  const ocean::Environment* environment_;  // borrowed; outlives the map
  core::Metres least_depth_;
  StandingZones zones_;
  plane::PlaneRaster raster_;
  geo::BoundingBox detailed_;       // the raster and a small margin
  std::vector<geo::Polygon> land_;  // land of the environment, exact inside this box only
  std::vector<CellState> cells_;
  std::vector<std::uint8_t>
      clearance_;  // cells that are open in every direction; 0: the cell is closed; at most 255
};

}  // namespace floeplan::planning::obstacles

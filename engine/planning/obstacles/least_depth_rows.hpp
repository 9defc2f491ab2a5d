#pragma once

#include <cstdint>
#include <optional>
#include <stop_token>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/ocean/bed/bathymetry.hpp"
#include "engine/planning/plane/fast_axis.hpp"
#include "engine/planning/plane/grid_lookup.hpp"
#include "engine/planning/plane/plane_raster.hpp"

namespace floeplan::planning::obstacles {

/// The least depth in each cell of a raster, row by row from the lowest. It includes all places in the cell,
/// and a few around it if its sides do not run along the data's axes. The bed is bilinear between nodes, so
/// the least depth in a box of the data's coordinates lies at its corners, at the nodes inside it, or where
/// grid lines cross its sides.
/// Edges    within a few cells of a pole the sides of a cell bend in the data's coordinates, so the result is
///          less certain. The cell that contains the pole is known only if the data reach the pole
/// Threads  one at a time
class LeastDepthRows {
 public:
  /// `enough`  depths beyond this are not distinguished. All references are borrowed and must outlive this
  LeastDepthRows(const plane::PlaneRaster& raster, const ocean::Bathymetry& bathymetry, core::Metres enough,
                 const geo::LocalProjection& projection, const std::stop_token& stop);

  /// Least depths of the cells of the next row, in metres: zero or less on land, NaN if a part of the cell is
  /// unknown.
  [[nodiscard]] const std::vector<float>& next();

 private:
  /// A corner of a cell in the data's coordinates, and the data cell that contains it, if any.
  struct Corner {
    double x{};
    double y{};
    std::optional<plane::CellPosition> column{};
    std::optional<plane::CellPosition> row{};
  };

  void fill(std::int64_t iy, std::vector<Corner>& corners) const;
  [[nodiscard]] float least_of(const Corner& a, const Corner& b, const Corner& c, const Corner& d);
  /// The least depth at the nodes of the data cells under and between the corners. Empty if a corner is
  /// outside all data cells, or a node is unknown.
  [[nodiscard]] std::optional<float> least_node(const Corner& a, const Corner& b, const Corner& c,
                                                const Corner& d) const;
  [[nodiscard]] float least_in_box(double west, double south, double east, double north);

  const plane::PlaneRaster& raster_;
  const ocean::Bathymetry& bathymetry_;
  float enough_m_;
  bool geographic_;
  plane::FastAxis columns_;
  plane::FastAxis rows_;
  plane::GridLookup lookup_;
  std::int64_t row_{};
  std::vector<Corner> below_;
  std::vector<Corner> above_;
  std::vector<float> least_m_;
  std::vector<ocean::AxisPosition> columns_of_box_;  // reused for each box
  std::vector<ocean::AxisPosition> rows_of_box_;
};

}  // namespace floeplan::planning::obstacles

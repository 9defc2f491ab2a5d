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

/// The least depth in each cell of a raster, row by row from the lowest: of all places in the cell, and of few around
/// it, where its sides do not run along the data's. Between its nodes the bed is bilinear, so that the least depth in a
/// box of the data's coordinates is found at its corners, at the nodes inside it and where the data's lines cross its
/// sides.
/// Edges    within few cells of a pole the sides of a cell bend in the data's coordinates, and less is certain; the
///          cell round it is known only where the data reach it
/// Threads  one at a time
class LeastDepthRows {
 public:
  /// `enough`  of a cell that is deeper, no more is told than that it is. All are borrowed, and outlive this
  LeastDepthRows(const plane::PlaneRaster& raster, const ocean::Bathymetry& bathymetry, core::Metres enough,
                 const geo::LocalProjection& projection, const std::stop_token& stop);

  /// Least depths of the cells of the next row, in metres: zero or less on land, NaN where part of a cell is not known.
  [[nodiscard]] const std::vector<float>& next();

 private:
  /// A corner of a cell in the data's coordinates; which of the data's cells holds it, where one does.
  struct Corner {
    double x{};
    double y{};
    std::optional<plane::CellPosition> column{};
    std::optional<plane::CellPosition> row{};
  };

  void fill(std::int64_t iy, std::vector<Corner>& corners) const;
  [[nodiscard]] float least_of(const Corner& a, const Corner& b, const Corner& c, const Corner& d) const;
  /// The least depth at the nodes of the data's cells under and between the corners; empty where the corners are not
  /// all within cells, or a node is not known.
  [[nodiscard]] std::optional<float> least_node(const Corner& a, const Corner& b, const Corner& c,
                                                const Corner& d) const;
  [[nodiscard]] float least_in_box(double west, double south, double east, double north) const;
  /// NaN where it is not known.
  [[nodiscard]] float depth_at(double x, double y) const;

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
};

}  // namespace floeplan::planning::obstacles

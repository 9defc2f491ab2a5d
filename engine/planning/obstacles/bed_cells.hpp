#pragma once

#include <cstddef>
#include <memory>
#include <stop_token>
#include <vector>

#include "engine/ocean/bed/bathymetry.hpp"
#include "engine/planning/obstacles/plane_bed.hpp"
#include "engine/planning/plane/plane_raster.hpp"
#include "engine/vehicle/glider_profile.hpp"

namespace floeplan::planning::obstacles {

/// Tests whether the water is deep enough all along a line, not only at samples. First the least depths of
/// the raster cells (`LeastDepthRows`) that the line enters are tested. If one is too shallow, the bed along
/// the line itself decides, so the result is the same on every raster.
/// Threads  const members may be called from several threads at once
class BedCells {
 public:
  /// `bathymetry` must not be null. `enough`: the largest depth that will be asked for. Once `stop` is
  /// requested the object stays incomplete and must not be used.
  BedCells(std::shared_ptr<const ocean::Bathymetry> bathymetry, core::Metres enough,
           const geo::LocalProjection& projection, const plane::PlaneBox& area, core::Metres cell,
           const std::stop_token& stop);

  /// Whether the bed is known at the point and at least at `depth`; false beyond the area.
  [[nodiscard]] bool is_deep_at(geo::PlanePoint point, core::Metres depth) const;
  /// Whether the bed is known and at least at `depth` all along the straight line from a to b.
  [[nodiscard]] bool is_deep_along(geo::PlanePoint a, geo::PlanePoint b, core::Metres depth) const;
  [[nodiscard]] const plane::PlaneRaster& raster() const { return raster_; }
  /// The least depth in a cell of the raster: zero or less on land, NaN if a part of the cell is unknown.
  [[nodiscard]] core::Metres least_depth(std::size_t cell) const {
    return core::Metres{static_cast<double>(least_m_[cell])};
  }
  [[nodiscard]] std::size_t bytes() const { return least_m_.size() * sizeof(float); }

 private:
  [[nodiscard]] bool has_deep_cells_along(geo::PlanePoint a, geo::PlanePoint b, core::Metres depth) const;

  PlaneBed bed_;
  plane::PlaneRaster raster_;
  std::vector<float> least_m_;
};

/// The sea bed for this vehicle: the largest depth asked for is its dive depth plus altimeter margin, or the
/// least water that it needs.
/// `bathymetry` must not be null.
[[nodiscard]] std::shared_ptr<const BedCells> lay_out_bed(std::shared_ptr<const ocean::Bathymetry> bathymetry,
                                                          const vehicle::GliderProfile& vehicle,
                                                          const geo::LocalProjection& projection,
                                                          const plane::PlaneBox& area, core::Metres cell,
                                                          const std::stop_token& stop);

}  // namespace floeplan::planning::obstacles

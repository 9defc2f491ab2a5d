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

/// Whether the water is deep enough all along a way, and not only where it is looked at. Decided by the least depth in
/// the cells of a raster (`LeastDepthRows`) that the way enters, where that is enough; else by the bed along the way
/// itself, so that the same way is judged alike on every raster.
/// Threads  const members may be called from several threads at once
class BedCells {
 public:
  /// `bathymetry` must not be null. `enough`  the most that is ever asked for. Once `stop` is requested it stays
  /// incomplete and must not be used
  BedCells(std::shared_ptr<const ocean::Bathymetry> bathymetry, core::Metres enough,
           const geo::LocalProjection& projection, const plane::PlaneBox& area, core::Metres cell,
           const std::stop_token& stop);

  /// Whether the bed is known there and at least so deep; false beyond the area.
  [[nodiscard]] bool is_deep_at(geo::PlanePoint point, core::Metres depth) const;
  /// The same all along the straight line from a to b.
  [[nodiscard]] bool is_deep_along(geo::PlanePoint a, geo::PlanePoint b, core::Metres depth) const;
  [[nodiscard]] const plane::PlaneRaster& raster() const { return raster_; }
  /// The least depth known in a cell of the raster.
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

/// For a vehicle that may be asked to dive as deep as its dives go.
[[nodiscard]] std::shared_ptr<const BedCells> lay_out_bed(std::shared_ptr<const ocean::Bathymetry> bathymetry,
                                                          const vehicle::GliderProfile& vehicle,
                                                          const geo::LocalProjection& projection,
                                                          const plane::PlaneBox& area, core::Metres cell,
                                                          const std::stop_token& stop);

}  // namespace floeplan::planning::obstacles

#pragma once

#include <memory>
#include <optional>

#include "engine/geo/local_projection.hpp"
#include "engine/ocean/bed/bathymetry.hpp"
#include "engine/planning/obstacles/plane_bed.hpp"
#include "engine/planning/plane/plane_box.hpp"

namespace floeplan::simulation {

/// The sea bed of a flight: none, flat, or from a bathymetry, bilinear between its nodes.
/// Threads  const members may be called from several threads at once
class SeaBed {
 public:
  SeaBed() = default;  // no sea bed: infinitely deep
  explicit SeaBed(core::Metres flat) : flat_{flat.value} {}
  /// `bathymetry` must not be null.
  SeaBed(std::shared_ptr<const ocean::Bathymetry> bathymetry, const geo::LocalProjection& projection,
         const planning::plane::PlaneBox& area)
      : data_{planning::obstacles::PlaneBed{std::move(bathymetry), projection, area, {}}}, area_{area} {}

  /// Depth, positive down; empty if there is no bed, and where it is unknown, such as outside the area.
  [[nodiscard]] std::optional<double> depth_m(double east_m, double north_m) const {
    if (!data_) return flat_;
    if (!area_.contains({east_m, north_m})) return std::nullopt;
    const auto depth = data_->depth({east_m, north_m});
    if (!depth) return std::nullopt;
    return depth->value;
  }
  /// Whether the bed comes from data, which end somewhere.
  [[nodiscard]] bool has_data() const { return data_.has_value(); }

 private:
  std::optional<double> flat_{};
  std::optional<planning::obstacles::PlaneBed> data_{};
  planning::plane::PlaneBox area_{};
};

}  // namespace floeplan::simulation

#pragma once

#include <memory>

#include "engine/ocean/bed/bathymetry.hpp"
#include "engine/vehicle/dive_band.hpp"

namespace floeplan::planning::currents {

/// The depths between which a glider dives (saw-tooth) at each place.
/// Threads  const members may be called from several threads at once
class FlownDepths {
 public:
  /// Without bathymetry (null) the vehicle dives to the requested depth everywhere.
  FlownDepths(const vehicle::DiveLimits& limits, std::shared_ptr<const ocean::Bathymetry> bathymetry);

  /// The depths between which the vehicle dives at a place. Where the sea bed is not known it dives as deep as
  /// requested.
  [[nodiscard]] vehicle::DiveBand at(geo::LonLat place) const;
  [[nodiscard]] const vehicle::DiveLimits& limits() const { return limits_; }
  [[nodiscard]] const std::shared_ptr<const ocean::Bathymetry>& bathymetry() const { return bathymetry_; }

 private:
  vehicle::DiveLimits limits_;
  std::shared_ptr<const ocean::Bathymetry> bathymetry_;
};

}  // namespace floeplan::planning::currents

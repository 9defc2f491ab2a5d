#include "engine/planning/currents/flown_depths.hpp"

#include <utility>

namespace floeplan::planning::currents {

FlownDepths::FlownDepths(const vehicle::DiveLimits& limits,
                         std::shared_ptr<const ocean::Bathymetry> bathymetry)
    : limits_{limits}, bathymetry_{std::move(bathymetry)} {}

vehicle::DiveBand FlownDepths::at(geo::LonLat place) const {
  if (!bathymetry_) return vehicle::flown_band(limits_, std::nullopt);
  return vehicle::flown_band(limits_, bathymetry_->shoalest(place));
}

}  // namespace floeplan::planning::currents

#pragma once

#include <algorithm>
#include <stop_token>
#include <vector>

#include "engine/ocean/environment.hpp"
#include "engine/planning/ice_cover.hpp"

namespace floeplan::planning {

/// The sea ice of all products that an environment holds. At each place and time the first of them that speaks for that
/// time and knows the place answers, by its own data before what they are extended by; where none does, the one that
/// holds the step nearest to that time.
/// Outside  nothing known where none of them knows; the deepest keel that any of them knew last
/// Threads  const members may be called from several threads at once
class IceCovers {
 public:
  /// Once `stop` is requested the covers stay incomplete and must not be used. `environment` must have ice.
  IceCovers(const ocean::Environment& environment, const UnderIceRules& rules,
            const geo::LocalProjection& projection, const PlaneBox& area, core::UtcTime epoch,
            const std::stop_token& stop = {});

  [[nodiscard]] IceAbove above(geo::PlanePoint point, core::Seconds time) const {
    return covers_.size() == 1 ? covers_.front().above(point, time) : first_known(point, time);
  }
  /// As the members of `IceCover` of these names; a bound where several covers are less sharp together.
  [[nodiscard]] bool has_dense_ice() const { return std::ranges::any_of(covers_, &IceCover::has_dense_ice); }
  [[nodiscard]] bool changes() const;
  [[nodiscard]] core::Metres least_way_to_opening(geo::PlanePoint point) const;
  [[nodiscard]] std::vector<core::Metres> least_ways_to_opening(const std::vector<geo::PlanePoint>& points,
                                                                core::Seconds from,
                                                                core::Seconds until) const;
  [[nodiscard]] core::Metres least_way_to_dense_ice(geo::PlanePoint point) const;
  [[nodiscard]] core::Seconds last_step() const;
  [[nodiscard]] core::Metres spacing() const;
  [[nodiscard]] std::size_t bytes() const;

 private:
  [[nodiscard]] IceAbove first_known(geo::PlanePoint point, core::Seconds time) const;
  /// By the step nearest to a time for which none that knows the place speaks.
  [[nodiscard]] IceAbove held(geo::PlanePoint point, core::Seconds time) const;

  std::vector<IceCover> covers_;
};

}  // namespace floeplan::planning

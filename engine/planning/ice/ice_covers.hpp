#pragma once

#include <algorithm>
#include <optional>
#include <stop_token>
#include <vector>

#include "engine/ocean/environment.hpp"
#include "engine/planning/ice/ice_cover.hpp"

namespace floeplan::planning::ice {

/// The sea ice of all products that an environment holds.
/// Choice   at each place and time the first of them answers that knows the place and whose own data are of that time,
///          else the one with the nearest step that speaks for it, else with the nearest that is held for it
///          (ocean::IceStanding); of each, data of the place before what they are extended by
/// Keels    where that one tells no thickness, those of the next in this order that does and has dense ice there; only
///          where none does, the assumed ones
/// Outside  where the first of all products may be held only for times after the epoch, open water is assumed until
///          then, as with no product at all. Else nothing is known where none of them knows; the deepest keel that any
///          of them knew last
/// Threads  const members may be called from several threads at once
class IceCovers {
 public:
  /// Once `stop` is requested the covers stay incomplete and must not be used. `environment` must have ice.
  IceCovers(const ocean::Environment& environment, const UnderIceRules& rules,
            const geo::LocalProjection& projection, const plane::PlaneBox& area, core::UtcTime epoch,
            const std::stop_token& stop = {});

  [[nodiscard]] IceAbove above(geo::PlanePoint point, core::Seconds time) const {
    if (open_until_ && time < *open_until_) return {.known = true, .may_surface = true, .draft_m = 0.0};
    return covers_.size() == 1 ? covers_.front().above(point, time) : first_known(point, time);
  }
  /// As the members of `IceCover` of these names; a bound where several covers are less sharp together.
  [[nodiscard]] bool has_dense_ice() const { return std::ranges::any_of(covers_, &IceCover::has_dense_ice); }
  [[nodiscard]] core::Metres least_way_to_opening(geo::PlanePoint point) const;
  [[nodiscard]] std::vector<core::Metres> least_ways_to_opening(const std::vector<geo::PlanePoint>& points,
                                                                core::Seconds from,
                                                                core::Seconds until) const;
  [[nodiscard]] core::Metres least_way_to_dense_ice(geo::PlanePoint point) const;
  [[nodiscard]] core::Seconds last_step() const;
  [[nodiscard]] core::Metres spacing() const;
  [[nodiscard]] std::size_t bytes() const;

 private:
  struct Answer {
    const IceCover* cover;
    IceAbove ice;
  };
  [[nodiscard]] IceAbove first_known(geo::PlanePoint point, core::Seconds time) const;
  /// The first, in the order in which they are asked, that `accept` takes.
  template <class Accept>
  [[nodiscard]] std::optional<Answer> first_of(geo::PlanePoint point, core::Seconds time,
                                               const Accept& accept) const;

  std::vector<IceCover> covers_;
  std::optional<core::Seconds> open_until_{};  // empty: some ice is stored for the epoch
};

}  // namespace floeplan::planning::ice

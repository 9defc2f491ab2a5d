#pragma once

#include <algorithm>
#include <optional>
#include <stop_token>
#include <vector>

#include "engine/ocean/environment.hpp"
#include "engine/planning/ice/ice_cover.hpp"

namespace floeplan::planning::ice {

/// The sea ice of all products in an environment.
/// Choice   One product is used for each place and time: the first that covers both; otherwise the one with
///          the nearest step that counts for the time; otherwise the one with the nearest step that is held
///          for it (ocean::IceStanding). Within a product, data of the place itself come before data extended
///          from a neighbour
/// Keels    If that product has no thickness, the next one in this order that has thickness and dense ice
///          there gives the keels; if there is none, they are assumed
/// Outside  If the earliest step of all products may be held only from some time after the epoch on, open
///          water is assumed until that time, as without any product. Otherwise the ice is unknown where no
///          product covers it; the deepest keel last known to any product remains
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
  /// As the members of `IceCover`; with several products the bounds are less sharp.
  [[nodiscard]] bool has_dense_ice() const { return std::ranges::any_of(covers_, &IceCover::has_dense_ice); }
  [[nodiscard]] core::Metres deepest_draft() const;
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
  /// The first product, in the order of choice, that `accept` accepts.
  template <class Accept>
  [[nodiscard]] std::optional<Answer> first_of(geo::PlanePoint point, core::Seconds time,
                                               const Accept& accept) const;

  std::vector<IceCover> covers_;
  std::optional<core::Seconds> open_until_{};  // empty: some ice is stored for the epoch
};

}  // namespace floeplan::planning::ice

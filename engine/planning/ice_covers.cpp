#include "engine/planning/ice_covers.hpp"

#include <limits>
#include <optional>

namespace floeplan::planning {

IceCovers::IceCovers(const ocean::Environment& environment, const UnderIceRules& rules,
                     const geo::LocalProjection& projection, const PlaneBox& area, core::UtcTime epoch,
                     const std::stop_token& stop) {
  covers_.reserve(1 + environment.further_ice.size());
  covers_.emplace_back(*environment.ice, rules, projection, area, epoch, stop);
  for (const auto& ice : environment.further_ice)
    covers_.emplace_back(*ice, rules, projection, area, epoch, stop);
}

IceAbove IceCovers::first_known(geo::PlanePoint point, core::Seconds time) const {
  std::optional<IceAbove> extended;
  for (const IceCover& cover : covers_) {
    if (!cover.speaks_for(time)) continue;
    const IceAbove ice = cover.above(point, time);
    if (!ice.known) continue;
    if (!cover.is_extended(point, time)) return ice;
    if (!extended) extended = ice;
  }
  return extended ? *extended : held(point, time);
}

IceAbove IceCovers::held(geo::PlanePoint point, core::Seconds time) const {
  std::optional<IceAbove> known;
  core::Seconds nearest{std::numeric_limits<double>::infinity()};
  IceAbove unknown;
  for (const IceCover& cover : covers_) {
    const IceAbove ice = cover.above(point, time);
    if (!ice.known) {
      unknown.draft_m = std::max(unknown.draft_m, ice.draft_m);
    } else if (cover.beyond_steps(time) < nearest) {
      known = ice;
      nearest = cover.beyond_steps(time);
    }
  }
  return known.value_or(unknown);
}

bool IceCovers::changes() const { return covers_.size() == 1 ? covers_.front().changes() : has_dense_ice(); }

core::Metres IceCovers::least_way_to_opening(geo::PlanePoint point) const {
  core::Metres least = covers_.front().least_way_to_opening(point);
  for (const IceCover& cover : covers_) least = std::min(least, cover.least_way_to_opening(point));
  return least;
}

std::vector<core::Metres> IceCovers::least_ways_to_opening(const std::vector<geo::PlanePoint>& points,
                                                           core::Seconds from, core::Seconds until) const {
  std::vector<core::Metres> least = covers_.front().least_ways_to_opening(points, from, until);
  for (std::size_t i = 1; i < covers_.size(); ++i) {
    const std::vector<core::Metres> ways = covers_[i].least_ways_to_opening(points, from, until);
    std::ranges::transform(least, ways, least.begin(),
                           [](core::Metres a, core::Metres b) { return std::min(a, b); });
  }
  return least;
}

core::Metres IceCovers::least_way_to_dense_ice(geo::PlanePoint point) const {
  core::Metres least = covers_.front().least_way_to_dense_ice(point);
  for (const IceCover& cover : covers_) least = std::min(least, cover.least_way_to_dense_ice(point));
  return least;
}

core::Seconds IceCovers::last_step() const {
  return std::ranges::max(covers_, {}, &IceCover::last_step).last_step();
}

core::Metres IceCovers::spacing() const {
  return std::ranges::min(covers_, {}, &IceCover::spacing).spacing();
}

std::size_t IceCovers::bytes() const {
  std::size_t bytes = 0;
  for (const IceCover& cover : covers_) bytes += cover.bytes();
  return bytes;
}

}  // namespace floeplan::planning

#include "engine/planning/ice/ice_covers.hpp"

#include <utility>

namespace floeplan::planning::ice {

IceCovers::IceCovers(const ocean::Environment& environment, const UnderIceRules& rules,
                     const geo::LocalProjection& projection, const plane::PlaneBox& area, core::UtcTime epoch,
                     const std::stop_token& stop) {
  covers_.reserve(1 + environment.further_ice.size());
  covers_.emplace_back(*environment.ice, rules, projection, area, epoch, stop);
  for (const auto& ice : environment.further_ice)
    covers_.emplace_back(*ice, rules, projection, area, epoch, stop);
  const core::Seconds begins =
      std::ranges::min(covers_, {}, &IceCover::first_step).first_step() - ocean::longest_ice_hold;
  if (begins.count() > 0.0) open_until_ = begins;
}

template <class Accept>
std::optional<IceCovers::Answer> IceCovers::first_of(geo::PlanePoint point, core::Seconds time,
                                                     const Accept& accept) const {
  using ocean::IceStanding;
  for (const IceStanding standing : {IceStanding::own, IceStanding::speaks, IceStanding::held}) {
    std::optional<Answer> first;
    std::pair<bool, core::Seconds> least{};  // whether the data are extended, and the time to their step
    for (const IceCover& cover : covers_) {
      const ocean::IceMoment moment = cover.moment(time);
      if (moment.standing != standing) continue;
      const Answer answer{&cover, cover.above(point, time)};
      if (!accept(answer)) continue;
      const std::pair rank{cover.is_extended(point, time),
                           standing == IceStanding::own ? core::Seconds{0.0} : moment.away};
      if (first && !(rank < least)) continue;
      first = answer;
      least = rank;
      if (standing == IceStanding::own && !rank.first) break;
    }
    if (first) return first;
  }
  return std::nullopt;
}

IceAbove IceCovers::first_known(geo::PlanePoint point, core::Seconds time) const {
  const auto answer = first_of(point, time, [](const Answer& found) { return found.ice.known; });
  if (!answer) {
    IceAbove unknown;
    for (const IceCover& cover : covers_)
      unknown.draft_m = std::max(unknown.draft_m, cover.above(point, time).draft_m);
    return unknown;
  }
  if (answer->ice.may_surface) return answer->ice;

  const IceCover::Keels keels = answer->cover->keels(point, time);
  if (keels.all_told) return answer->ice;
  const auto told = first_of(point, time, [&](const Answer& found) {
    return found.ice.known && !found.ice.may_surface && found.cover->keels(point, time).all_told;
  });
  IceAbove ice = answer->ice;
  if (told) ice.draft_m = std::max(keels.told_m, told->ice.draft_m);
  return ice;
}

core::Metres IceCovers::deepest_draft() const {
  return std::ranges::max(covers_, {}, &IceCover::deepest_draft).deepest_draft();
}

core::Metres IceCovers::least_way_to_opening(geo::PlanePoint point) const {
  if (open_until_) return core::Metres{0.0};
  core::Metres least = covers_.front().least_way_to_opening(point);
  for (const IceCover& cover : covers_) least = std::min(least, cover.least_way_to_opening(point));
  return least;
}

std::vector<core::Metres> IceCovers::least_ways_to_opening(const std::vector<geo::PlanePoint>& points,
                                                           core::Seconds from, core::Seconds until) const {
  if (open_until_ && from < *open_until_) return std::vector<core::Metres>(points.size(), core::Metres{0.0});
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

}  // namespace floeplan::planning::ice

#include "engine/planning/publish/held_legs.hpp"

#include <algorithm>

#include "engine/planning/cost/hold_times.hpp"

namespace floeplan::planning::publish {
namespace {

/// A hold may end this much earlier after its place was moved.
constexpr core::Seconds leeway{3600.0};
constexpr core::Seconds tardiness{2.0};
/// The place of a hold may be moved by this share of the shorter leg beside it. A judgement.
constexpr double share_about = 0.25;

}  // namespace

HeldLegs::HeldLegs(const cost::Sea& sea, const cost::Route& route, const cost::Schedule& schedule)
    : sea_{sea} {
  const auto& points = route.points;
  std::vector<core::Seconds> ends;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    if (schedule.waits[i].count() <= 0.0) continue;
    double leg_m = geo::distance_m(points[i], points[i + 1]);
    if (i > 0) leg_m = std::min(leg_m, geo::distance_m(points[i - 1], points[i]));
    const core::Seconds end = schedule.leaves(i);
    holds_.push_back({points[i], core::Metres{share_about * leg_m}, end - leeway});
    ends.push_back(end);
  }
  if (keeps(route, schedule)) return;
  // With the leeway the vehicle would depart too early and meet a closure. So each hold ends as scheduled.
  for (std::size_t i = 0; i < holds_.size(); ++i) holds_[i].no_sooner = ends[i];
}

tl::expected<core::Seconds, motion::EdgeClosed> HeldLegs::operator()(geo::PlanePoint a, geo::PlanePoint b,
                                                                     core::Seconds depart) const {
  const auto hold = std::ranges::find_if(
      holds_, [&](const Hold& each) { return geo::distance_m(each.place, a) <= each.about.value; });
  if (hold == holds_.end()) return sea_.leg_time(a, b, depart);
  return after_hold(a, b, depart, hold->no_sooner);
}

tl::expected<core::Seconds, motion::EdgeClosed> HeldLegs::after_hold(geo::PlanePoint a, geo::PlanePoint b,
                                                                     core::Seconds depart,
                                                                     core::Seconds no_sooner) const {
  const auto at_once = sea_.leg_time(a, b, depart);
  if (at_once && depart >= no_sooner) return at_once;
  const core::Seconds stays = cost::can_stay_until(sea_, a, depart, depart + sea_.holding().longest);
  core::Seconds from = std::max(depart, no_sooner);
  while (from < stays) {
    const cost::OpenLegLook look = cost::next_open_leg(sea_, a, b, {from, stays}, depart);
    if (look.leg) {
      // Not at the first open second: the following leg may close at that second.
      const core::Seconds leaves = std::min(look.leg->depart + tardiness, stays);
      const auto time = sea_.leg_time(a, b, leaves);
      return time ? leaves + *time - depart : look.leg->arrival() - depart;
    }
    from = look.looked_until;
  }
  return tl::unexpected(at_once ? motion::EdgeClosed::too_late : at_once.error());
}

bool HeldLegs::keeps(const cost::Route& route, const cost::Schedule& schedule) const {
  constexpr core::Seconds rounding{10.0};
  core::Seconds now = schedule.arrivals.front();
  for (std::size_t i = 1; i < route.points.size(); ++i) {
    const auto time = (*this)(route.points[i - 1], route.points[i], now);
    if (!time) return false;
    now += *time;
  }
  return now <= schedule.arrivals.back() + rounding;
}

}  // namespace floeplan::planning::publish

#include "engine/planning/publish/held_legs.hpp"

#include <algorithm>

#include "engine/planning/cost/hold_times.hpp"

namespace floeplan::planning::publish {
namespace {

/// How much later a hold ends than by the schedule: a leg that was moved a little opens a few seconds later. What is lost is
/// won back when the holds are timed again. A judgement.
constexpr core::Seconds tardiness{2.0};
/// Share of the legs beside a hold: how far its place may be moved. A judgement.
constexpr double share_about = 0.25;

}  // namespace

HeldLegs::HeldLegs(const cost::Sea& sea, const cost::Route& route, const cost::Schedule& schedule)
    : sea_{sea} {
  const auto& points = route.points;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    if (schedule.waits[i].count() <= 0.0) continue;
    double leg_m = geo::distance_m(points[i], points[i + 1]);
    if (i > 0) leg_m = std::min(leg_m, geo::distance_m(points[i - 1], points[i]));
    holds_.push_back({points[i], core::Metres{share_about * leg_m}, schedule.leaves(i)});
  }
}

tl::expected<core::Seconds, motion::EdgeClosed> HeldLegs::operator()(geo::PlanePoint a, geo::PlanePoint b,
                                                                     core::Seconds depart) const {
  const auto hold = std::ranges::find_if(
      holds_, [&](const Hold& each) { return geo::distance_m(each.place, a) <= each.about.value; });
  if (hold == holds_.end()) return sea_.leg_time(a, b, depart);
  const core::Seconds leaves = std::max(depart, hold->ends + tardiness);
  if (leaves > depart && cost::can_stay_until(sea_, a, depart, leaves) < leaves)
    return tl::unexpected(motion::EdgeClosed::too_late);
  return sea_.leg_time(a, b, leaves).map([&](core::Seconds time) { return leaves + time - depart; });
}

}  // namespace floeplan::planning::publish

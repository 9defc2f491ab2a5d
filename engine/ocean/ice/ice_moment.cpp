#include "engine/ocean/ice/ice_moment.hpp"

#include <algorithm>
#include <cassert>

namespace floeplan::ocean {
namespace {

constexpr core::Seconds at_a_step{1e-3};  // rounding error of times

IceStanding standing_before_all(core::Seconds until) {
  if (until <= at_a_step) return IceStanding::own;
  if (until <= ice_speaks_before) return IceStanding::speaks;
  return until <= longest_ice_hold ? IceStanding::held : IceStanding::not_begun;
}

IceStanding standing_after_all(core::Seconds since) {
  if (since <= at_a_step) return IceStanding::own;
  if (since <= ice_speaks_after) return IceStanding::speaks;
  return since <= longest_ice_hold ? IceStanding::held : IceStanding::unknown;
}

IceStanding standing_between(core::Seconds since, core::Seconds until) {
  const core::Seconds nearest = std::min(since, until);
  if (since + until <= longest_ice_step || nearest <= at_a_step) return IceStanding::own;
  if (since <= ice_speaks_after || until <= ice_speaks_before) return IceStanding::speaks;
  const bool is_held = since + until <= longest_ice_gap || nearest <= longest_ice_hold;
  return is_held ? IceStanding::held : IceStanding::unknown;
}

}  // namespace

IceMoment ice_moment(const std::vector<double>& times_s, double time_s) {
  assert(!times_s.empty());
  const auto after = std::ranges::upper_bound(times_s, time_s);
  const std::size_t last = times_s.size() - 1;
  if (after == times_s.begin()) {
    const core::Seconds until{times_s.front() - time_s};
    return {0, 0, 0.0, standing_before_all(until), until};
  }
  if (after == times_s.end()) {
    const core::Seconds since{time_s - times_s.back()};
    return {last, last, 0.0, standing_after_all(since), since};
  }

  const auto second = static_cast<std::size_t>(after - times_s.begin());
  const core::Seconds since{time_s - times_s[second - 1]};
  const core::Seconds until{times_s[second] - time_s};
  IceMoment moment{.first = second - 1,
                   .second = second,
                   .share = since / (since + until),
                   .standing = standing_between(since, until),
                   .away = std::min(since, until)};
  if (since + until > longest_ice_gap && moment.is_known()) {
    moment.first = moment.second = since <= until ? second - 1 : second;
    moment.share = 0.0;
  }
  return moment;
}

}  // namespace floeplan::ocean

#include "engine/planning/cost/loiter.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace floeplan::planning::cost {
namespace {

constexpr core::Seconds between_looks{900.0};
constexpr int most_tries = 8;  // of a leg, each at a departure at which the straight and even way is clear
constexpr int tries_in_currents = 48;  // a tidal cycle in quarters of an hour
constexpr double tries_per_time_step = 4.0;
constexpr core::Seconds least_delay{30.0};
constexpr double least_delay_share = 0.02;  // of the leg's time

bool opens_again(motion::EdgeClosed closed) {
  return closed == motion::EdgeClosed::obstacle || closed == motion::EdgeClosed::in_zone;
}

/// Last look until which the vehicle keeps its place against the current and below the ice; before `from`: not at all.
core::Seconds held_until(const Sea& sea, geo::PlanePoint place, core::Seconds from, core::Seconds until) {
  // Between two steps of the data a current changes evenly, and is never stronger than at the stronger of both.
  const auto next_look = [&](core::Seconds now) {
    const core::Seconds step = sea.currents() ? sea.currents()->next_step(now) : until;
    return std::min({now + between_looks, step, until});
  };
  core::Seconds held = from - between_looks;
  for (core::Seconds now = from;; now = next_look(now)) {
    if (!sea.holds_against_current(place, now)) return held;
    if (sea.ice() && !sea.ice()->may_transit(place, now)) return held;
    held = now;
    if (now >= until) return held;
  }
}

/// The leg with the least wait, to within `punctual`, that is open after a departure that was refused.
WaitedLeg soonest(const Sea& sea, geo::PlanePoint a, geo::PlanePoint b, core::Seconds arrive,
                  core::Seconds latest, std::optional<core::Seconds> refused, WaitedLeg open) {
  if (!refused) return open;
  core::Seconds closed = *refused - arrive;
  while (open.wait - closed > punctual) {
    const core::Seconds middle = 0.5 * (closed + open.wait);
    const auto time = sea.leg_time(a, b, arrive + middle, latest);
    if (time) {
      open = {middle, *time};
    } else {
      closed = middle;
    }
  }
  return open;
}

/// The leg once the current that closes it at the arrival has slackened.
tl::expected<WaitedLeg, motion::EdgeClosed> leg_when_slack(const Sea& sea, geo::PlanePoint a,
                                                           geo::PlanePoint b, core::Seconds arrive,
                                                           core::Seconds latest, core::Seconds not_before) {
  const auto closed = tl::unexpected(motion::EdgeClosed::current_too_strong);
  if (!sea.currents() || !sea.currents()->time_step()) return closed;
  const core::Seconds stays = can_stay_until(sea, a, arrive, arrive + sea.longest_wait());
  const core::Seconds between = between_tries(sea, stays - arrive);
  core::Seconds refused = arrive;
  while (refused < stays) {
    const core::Seconds depart = std::min(refused + between, stays);
    if (const auto time = sea.leg_time(a, b, depart, latest); time && depart >= not_before)
      return soonest(sea, a, b, arrive, latest, std::max(refused, not_before), {depart - arrive, *time});
    refused = depart;
  }
  return closed;
}

}  // namespace

bool waits_may_help(const Sea& sea) {
  const bool currents_change = sea.currents() && sea.currents()->time_step();
  return sea.longest_wait().count() > 0.0 && (sea.has_timed_closures() || currents_change);
}

core::Seconds next_closure(const Sea& sea, geo::PlanePoint place, core::Seconds from) {
  for (const TimeSpan& closed : sea.closed_times(place))
    if (closed.until >= from) return closed.from;
  return core::Seconds{INFINITY};
}

core::Seconds can_stay_until(const Sea& sea, geo::PlanePoint place, core::Seconds from, core::Seconds until) {
  until = std::min(until, next_closure(sea, place, from));
  return until < from ? until : held_until(sea, place, from, until);
}

bool current_lets_stay(const Sea& sea, geo::PlanePoint place, core::Seconds from, core::Seconds until) {
  return held_until(sea, place, from, until) >= until;
}

core::Seconds between_tries(const Sea& sea, core::Seconds stays) {
  return std::max(*sea.currents()->time_step() / tries_per_time_step, stays / tries_in_currents);
}

core::Seconds fineness_of_waits(core::Seconds leg_time) {
  return std::max(least_delay, least_delay_share * leg_time);
}

tl::expected<WaitedLeg, motion::EdgeClosed> leg_when_open(const Sea& sea, geo::PlanePoint a,
                                                          geo::PlanePoint b, core::Seconds arrive,
                                                          core::Seconds latest, core::Seconds not_before) {
  const core::Seconds earliest = std::max(arrive, not_before);
  const auto at_once = sea.leg_time(a, b, arrive, latest);
  if (at_once && earliest == arrive) return WaitedLeg{core::Seconds{0.0}, *at_once};
  if (!at_once && at_once.error() == motion::EdgeClosed::current_too_strong && waits_may_help(sea))
    return leg_when_slack(sea, a, b, arrive, latest, earliest);
  const bool may_wait = sea.longest_wait().count() > 0.0 && sea.has_timed_closures();
  if (!may_wait || (!at_once && !opens_again(at_once.error())))
    return at_once.map([](core::Seconds time) { return WaitedLeg{core::Seconds{0.0}, time}; });
  const auto closed = tl::unexpected(at_once ? motion::EdgeClosed::too_late : at_once.error());
  if (sea.closed_between(a, b)) return closed;

  const core::Seconds stays = can_stay_until(sea, a, arrive, arrive + sea.longest_wait());
  core::Seconds depart = earliest;
  std::optional<core::Seconds> refused;
  for (int i = 0; i < most_tries && depart <= stays; ++i) {
    const auto unhindered = sea.leg_time_without_timed_closures(a, b, depart, latest);
    if (!unhindered) return closed;
    const auto clear = sea.first_clear_departure(a, b, *unhindered, depart, stays);
    if (!clear) return closed;
    depart = *clear;
    const auto time = sea.leg_time(a, b, depart, latest);
    if (time) return soonest(sea, a, b, arrive, latest, refused, {depart - arrive, *time});
    if (!opens_again(time.error())) return closed;
    refused = depart;
    depart += fineness_of_waits(*unhindered);
  }
  return closed;
}

tl::expected<core::Seconds, motion::EdgeClosed> time_with_wait(const Sea& sea, geo::PlanePoint a,
                                                               geo::PlanePoint b, core::Seconds arrive) {
  return leg_when_open(sea, a, b, arrive).map([](const WaitedLeg& leg) { return leg.total(); });
}

std::size_t interval_of(const std::vector<TimeSpan>& closed, core::Seconds time) {
  return static_cast<std::size_t>(
      std::ranges::count_if(closed, [&](const TimeSpan& span) { return span.until < time; }));
}

}  // namespace floeplan::planning::cost

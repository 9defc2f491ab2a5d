#include "engine/planning/cost/hold_times.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/planning/cost/hold_circle.hpp"

namespace floeplan::planning::cost {
namespace {

constexpr core::Seconds between_looks{900.0};
constexpr core::Seconds fineness_of_clear{5.0};  // tolerance of `Closures::first_clear_departure`
constexpr int most_tries = 8;          // of departures at which a straight drive at constant speed is clear
constexpr int tries_in_currents = 48;  // in the time of a hold: quarters of an hour in 12 h, a tidal cycle
constexpr double tries_per_time_step = 4.0;
constexpr core::Seconds least_delay{30.0};
constexpr double least_delay_share = 0.02;  // share of the leg's time

bool opens_again(motion::EdgeClosed closed) {
  return closed == motion::EdgeClosed::obstacle || closed == motion::EdgeClosed::in_zone;
}

/// The end of the period with known currents, but at most `until`.
core::Seconds known_until(const Sea& sea, core::Seconds until) {
  return sea.domain().currents() ? std::min(until, sea.domain().currents()->end().value_or(until)) : until;
}

/// The next time at which to check the current. Between two steps of the data a current changes linearly, so
/// its strongest values are at the steps.
core::Seconds next_look(const Sea& sea, core::Seconds now, core::Seconds until) {
  return sea.domain().currents() ? std::min(until, sea.domain().currents()->next_step(now)) : until;
}

/// The last checked time until which the vehicle stays within the circle. It is earlier than `from` if the
/// vehicle cannot hold at all.
core::Seconds held_until(const Sea& sea, const HoldCircle& circle, core::Seconds from, core::Seconds until) {
  core::Seconds held = from - between_looks;
  if (!circle.is_open() || !circle.is_kept(from)) return held;
  if (circle.is_always_kept()) return known_until(sea, until);
  for (core::Seconds now = from;; now = std::min(now + between_looks, next_look(sea, now, until))) {
    if (!circle.is_kept(now)) return held;
    held = now;
    if (now >= until) return held;
  }
}

/// The parts of `within` in which the vehicle can hold in the current; timed closures are ignored.
std::vector<TimeSpan> times_to_hold(const Sea& sea, const HoldCircle& circle, TimeSpan within) {
  constexpr core::Seconds to_a_second{1.0};
  if (!circle.is_open()) return {};
  if (circle.is_always_kept()) {
    if (!circle.is_kept(within.from)) return {};  // at the beginning the current is unknown or too strong
    return {{within.from, known_until(sea, within.until)}};
  }
  std::vector<TimeSpan> result;
  core::Seconds now = within.from;
  core::Seconds begins = now;
  bool holds = circle.is_kept(now);
  while (now < within.until) {
    core::Seconds next = next_look(sea, now, within.until);
    if (circle.is_below_ice()) next = std::min(next, now + between_looks);
    const bool holds_then = circle.is_kept(next);
    if (holds_then != holds) {
      core::Seconds held = holds ? now : next;
      core::Seconds not_held = holds ? next : now;
      while (std::abs((held - not_held).count()) > to_a_second.count()) {
        const core::Seconds middle = 0.5 * (held + not_held);
        (circle.is_kept(middle) ? held : not_held) = middle;
      }
      if (holds) {
        result.push_back({begins, held});
      } else {
        begins = held;
      }
    }
    holds = holds_then;
    now = next;
  }
  if (holds) result.push_back({begins, within.until});
  return result;
}

/// The parts of `within` in which the vehicle can hold and no timed closure touches the circle.
std::vector<TimeSpan> clear_times_to_hold(const Sea& sea, const HoldCircle& circle, TimeSpan within) {
  std::vector<TimeSpan> result;
  const std::vector<TimeSpan> closures = circle.closed_times();
  for (const TimeSpan& held : times_to_hold(sea, circle, within)) {
    core::Seconds from = held.from;
    for (const TimeSpan& closed : closures) {
      if (closed.until < from || closed.from > held.until) continue;
      if (from < closed.from) result.push_back({from, closed.from});
      from = std::max(from, closed.until);
    }
    if (from < held.until) result.push_back({from, held.until});
  }
  return result;
}

/// Approximate departure from which the leg ends no earlier than `not_before`, if timed closures are ignored.
core::Seconds departure_for(const Sea& sea, geo::PlanePoint a, geo::PlanePoint b, core::Seconds earliest,
                            core::Seconds not_before) {
  if (not_before <= earliest + sea.least_time(a, b)) return earliest;
  const auto time = sea.leg_time_back_without_timed_closures(a, b, not_before, earliest);
  return time ? std::max(earliest, not_before - *time) : earliest;
}

/// The next departure to try when the leg is closed at `depart`. Empty: the leg cannot open.
/// `is_first`: set to true if the leg is certainly closed between the two departures
std::optional<core::Seconds> departure_after(const Sea& sea, geo::PlanePoint a, geo::PlanePoint b,
                                             core::Seconds depart, core::Seconds until,
                                             motion::EdgeClosed closed, bool& is_first) {
  is_first = false;
  core::Seconds unhindered{};
  if (opens_again(closed)) {
    const auto time = sea.leg_time_without_timed_closures(a, b, depart, core::Seconds{INFINITY});
    if (time) {
      unhindered = *time;
    } else {
      closed = time.error();
    }
  }
  if (opens_again(closed)) {
    const auto clear = sea.domain().closures().first_clear_departure(a, b, unhindered, depart, until);
    if (!clear) return std::nullopt;
    is_first = *clear > depart;
    return is_first ? *clear : depart + fineness_of_waits(unhindered);
  }
  if (closed == motion::EdgeClosed::under_ice) return depart + between_looks;
  if (closed != motion::EdgeClosed::current_too_strong || !sea.domain().currents() ||
      !sea.domain().currents()->time_step())
    return std::nullopt;
  return depart + std::max(between_looks, *sea.domain().currents()->time_step() / tries_per_time_step);
}

/// Shortens the wait of `open` between the departure that was refused and the open one, to within `punctual`.
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

/// The leg at the first tried departure at which the current no longer closes it.
tl::expected<WaitedLeg, motion::EdgeClosed> leg_when_slack(const Sea& sea, geo::PlanePoint a,
                                                           geo::PlanePoint b, core::Seconds arrive,
                                                           core::Seconds latest, core::Seconds not_before) {
  const auto closed = tl::unexpected(motion::EdgeClosed::current_too_strong);
  if (!sea.domain().currents() || !sea.domain().currents()->time_step()) return closed;
  const core::Seconds stays = can_stay_until(sea, a, arrive, arrive + sea.holding().longest);
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

bool holds_may_help(const Sea& sea) {
  const bool currents_change = sea.domain().currents() && sea.domain().currents()->time_step();
  return sea.holding().longest.count() > 0.0 && (sea.domain().closures().any_timed() || currents_change);
}

core::Seconds can_stay_until(const Sea& sea, geo::PlanePoint place, core::Seconds from, core::Seconds until) {
  const HoldCircle circle{sea, place};
  for (const TimeSpan& closed : circle.closed_times()) {
    if (closed.until < from) continue;
    until = std::min(until, closed.from);
    break;
  }
  return until < from ? until : held_until(sea, circle, from, until);
}

bool current_lets_stay(const Sea& sea, geo::PlanePoint place, core::Seconds from, core::Seconds until) {
  return held_until(sea, HoldCircle{sea, place}, from, until) >= until;
}

core::Seconds between_tries(const Sea& sea, core::Seconds stays) {
  return std::max(*sea.domain().currents()->time_step() / tries_per_time_step, stays / tries_in_currents);
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
  if (!at_once && at_once.error() == motion::EdgeClosed::current_too_strong && holds_may_help(sea))
    return leg_when_slack(sea, a, b, arrive, latest, earliest);
  const bool may_wait = sea.holding().longest.count() > 0.0 && sea.domain().closures().any_timed();
  if (!may_wait || (!at_once && !opens_again(at_once.error())))
    return at_once.map([](core::Seconds time) { return WaitedLeg{core::Seconds{0.0}, time}; });
  const auto closed = tl::unexpected(at_once ? motion::EdgeClosed::too_late : at_once.error());
  if (sea.domain().closures().closed_between(a, b)) return closed;

  const core::Seconds stays = can_stay_until(sea, a, arrive, arrive + sea.holding().longest);
  core::Seconds depart = earliest;
  std::optional<core::Seconds> refused;
  for (int i = 0; i < most_tries && depart <= stays; ++i) {
    const auto unhindered = sea.leg_time_without_timed_closures(a, b, depart, latest);
    if (!unhindered) return closed;
    const auto clear = sea.domain().closures().first_clear_departure(a, b, *unhindered, depart, stays);
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

OpenLegLook next_open_leg(const Sea& sea, geo::PlanePoint a, geo::PlanePoint b, TimeSpan departures,
                          core::Seconds not_before) {
  const OpenLegLook none{std::nullopt, core::Seconds{INFINITY}};
  if (sea.domain().closures().closed_between(a, b)) return none;
  const auto open_at = [&](core::Seconds depart) -> std::optional<OpenLeg> {
    const auto time = sea.leg_time(a, b, depart);
    if (!time || depart + *time < not_before) return std::nullopt;
    return OpenLeg{depart, *time};
  };
  core::Seconds depart = departure_for(sea, a, b, departures.from, not_before);
  std::optional<core::Seconds> refused;
  bool even_is_closed_until = false;  // for the next departure and a drive at constant speed
  for (int i = 0; i < most_tries; ++i) {
    if (depart > departures.until) {
      if (!refused || *refused >= departures.until) return none;
      depart = departures.until;
    }
    const auto time = sea.leg_time(a, b, depart);
    if (time && depart + *time >= not_before) {
      OpenLeg open{depart, *time};
      // The exact drive becomes clear a few seconds before or after a drive at constant speed.
      for (core::Seconds step = fineness_of_clear; even_is_closed_until && refused; step *= 2.0) {
        const core::Seconds before = std::max(*refused, depart - step);
        const auto earlier = before > *refused ? open_at(before) : std::nullopt;
        if (!earlier) {
          refused = before;
          break;
        }
        open = *earlier;
      }
      while (refused && open.depart - *refused > punctual) {
        const core::Seconds middle = 0.5 * (*refused + open.depart);
        if (const auto earlier = open_at(middle)) {
          open = *earlier;
        } else {
          refused = middle;
        }
      }
      return {open, open.depart};
    }
    if (time) {
      refused = depart;
      depart += std::max(not_before - (depart + *time), punctual);
      continue;
    }
    even_is_closed_until = false;
    const auto next =
        departure_after(sea, a, b, depart, departures.until, time.error(), even_is_closed_until);
    if (!next) return none;
    refused = depart;
    depart = *next;
  }
  return {std::nullopt, refused.value_or(depart)};
}

OpenLeg open_leg_until(const Sea& sea, geo::PlanePoint a, geo::PlanePoint b, const OpenLeg& leg,
                       core::Seconds latest_departure, core::Seconds latest_arrival) {
  constexpr core::Seconds least_step{300.0};
  constexpr int most_steps = 12;
  // A disc may pass in minutes; currents open and close at the pace of their data.
  const bool by_currents_alone =
      !sea.domain().closures().any_timed() && sea.domain().currents() && sea.domain().currents()->time_step();
  const core::Seconds step =
      by_currents_alone ? std::max(between_looks, *sea.domain().currents()->time_step() / tries_per_time_step)
                        : std::max(least_step, fineness_of_waits(leg.time));
  const auto open_at = [&](core::Seconds depart) -> std::optional<OpenLeg> {
    const auto time = sea.leg_time(a, b, depart);
    if (!time || depart + *time > latest_arrival) return std::nullopt;
    return OpenLeg{depart, *time};
  };
  OpenLeg last = leg;
  for (int i = 0; i < most_steps && last.depart < latest_departure; ++i) {
    core::Seconds closed = std::min(last.depart + step, latest_departure);
    if (const auto later = open_at(closed)) {
      last = *later;
      continue;
    }
    while (closed - last.depart > punctual) {
      const core::Seconds middle = 0.5 * (last.depart + closed);
      if (const auto later = open_at(middle)) {
        last = *later;
      } else {
        closed = middle;
      }
    }
    break;
  }
  return last;
}

std::vector<graph::SafeInterval> safe_intervals(const Sea& sea, geo::PlanePoint place, TimeSpan within) {
  std::vector<graph::SafeInterval> result;
  const std::vector<TimeSpan> holds = clear_times_to_hold(sea, HoldCircle{sea, place}, within);
  const auto add = [&](core::Seconds from, core::Seconds until, bool may_stay) {
    if (from < until) result.push_back({from.count(), until.count(), may_stay});
  };
  const auto add_clear = [&](core::Seconds from, core::Seconds until) {
    for (const TimeSpan& hold : holds) {
      if (hold.until <= from || hold.from >= until) continue;
      add(from, hold.from, false);
      const core::Seconds ends = std::min(hold.until, until);
      add(std::max(from, hold.from), ends, true);
      from = ends;
    }
    add(from, until, false);
  };
  core::Seconds from = within.from;
  for (const TimeSpan& closed : sea.domain().closures().closed_times(place)) {
    if (closed.until <= from) continue;
    if (closed.from >= within.until) break;
    add_clear(from, closed.from);
    from = closed.until;
  }
  add_clear(from, within.until);
  return result;
}

core::Seconds end_of_looks(const Sea& sea, core::Seconds depart, core::Metres way) {
  constexpr core::Seconds longest_look{10.0 * 86'400.0};
  constexpr double slowest_share =
      0.25;  // lower limit of a route's average speed, as a share of the speed through water
  const core::Seconds end = depart + longest_look + way / (slowest_share * sea.through_water());
  if (!sea.domain().currents()) return end;
  return std::min(end, sea.domain().currents()->end().value_or(end));
}

std::size_t interval_of(const std::vector<TimeSpan>& closed, core::Seconds time) {
  return static_cast<std::size_t>(
      std::ranges::count_if(closed, [&](const TimeSpan& span) { return span.until < time; }));
}

}  // namespace floeplan::planning::cost

#pragma once

#include <optional>
#include <tl/expected.hpp>
#include <utility>
#include <vector>

#include "engine/graph/interval_search.hpp"
#include "engine/motion/edge_closed.hpp"
#include "engine/planning/cost/sea.hpp"
#include "engine/planning/problem/time_span.hpp"

namespace floeplan::planning::cost {

/// A leg, and how long the vehicle holds at its beginning before it departs.
struct WaitedLeg {
  core::Seconds wait{};
  core::Seconds time{};  // of travel

  [[nodiscard]] core::Seconds total() const { return wait + time; }
};

/// Whether a hold can get the vehicle past a closure: the request allows holds, and zones, icebergs or currents close
/// places only for a while.
[[nodiscard]] bool holds_may_help(const Sea& sea);

/// The time until which the vehicle can hold at a place, at most `until`: while it can stay within its circle
/// (hold_circle.hpp) and no timed closure touches the circle.
/// Accuracy  room below the ice is checked every quarter of an hour; currents and closures are exact
[[nodiscard]] core::Seconds can_stay_until(const Sea& sea, geo::PlanePoint place, core::Seconds from,
                                           core::Seconds until);
/// Whether the vehicle can hold from `from` until `until` if timed closures are ignored.
[[nodiscard]] bool current_lets_stay(const Sea& sea, geo::PlanePoint place, core::Seconds from,
                                     core::Seconds until);

/// Tolerance of the shortest wait after a refused departure.
inline constexpr core::Seconds punctual{0.1};

/// Step between the departures that are tried when only the exact drive of a leg is closed; grows with the time of
/// the leg.
[[nodiscard]] core::Seconds fineness_of_waits(core::Seconds leg_time);

/// Step between the departures that are tried until a current slackens, for a vehicle that can hold for `stays`.
/// Precondition  the currents change with time
[[nodiscard]] core::Seconds between_tries(const Sea& sea, core::Seconds stays);

/// The leg for a vehicle that reaches its beginning at `arrive`: without a wait, or after the shortest wait within
/// the request's limit until a closure ends or a current slackens.
/// `not_before`: earliest departure, besides the arrival.
/// Errors    as Sea::leg_time, for the departure without a wait
/// Accuracy  that of obstacles::Closures::first_clear_departure; `punctual` if the leg is still closed at that departure and then
///           stays open. A leg that is open for less than `fineness_of_waits`, or a quarter of an hour, may be
///           missed. A leg that a current closed may be missed if it is open for less than `between_tries`
[[nodiscard]] tl::expected<WaitedLeg, motion::EdgeClosed> leg_when_open(
    const Sea& sea, geo::PlanePoint a, geo::PlanePoint b, core::Seconds arrive,
    core::Seconds latest = core::Seconds{INFINITY}, core::Seconds not_before = core::Seconds{0.0});

/// Wait and travel time of `leg_when_open` together.
[[nodiscard]] tl::expected<core::Seconds, motion::EdgeClosed> time_with_wait(const Sea& sea,
                                                                             geo::PlanePoint a,
                                                                             geo::PlanePoint b,
                                                                             core::Seconds arrive);

/// A departure at which a leg is open.
struct OpenLeg {
  core::Seconds depart;
  core::Seconds time;

  [[nodiscard]] core::Seconds arrival() const { return depart + time; }
};

/// Result of a search for an open leg.
struct OpenLegLook {
  std::optional<OpenLeg> leg;
  core::Seconds looked_until;  // no departure before this time is open
};

/// The first departure within a span at which the leg is open and ends no earlier than `not_before`. Tries only a few
/// departures; call it again from `looked_until` to continue.
/// Accuracy  as `leg_when_open`. Where a current or ice closes the leg, it may be missed if it is open for less than
///           a quarter of an hour, or less than a quarter of the data's time step
[[nodiscard]] OpenLegLook next_open_leg(const Sea& sea, geo::PlanePoint a, geo::PlanePoint b,
                                        TimeSpan departures, core::Seconds not_before);

/// The last departure, at most `latest_departure`, such that the leg stays open from `leg` to it and ends by
/// `latest_arrival`. Takes only a few steps; call it again from its result to continue.
/// Accuracy  `punctual`. A closure shorter than five minutes, or than a share of the leg's time, may be missed: the
///           caller times the leg of a departure before it uses it
[[nodiscard]] OpenLeg open_leg_until(const Sea& sea, geo::PlanePoint a, geo::PlanePoint b, const OpenLeg& leg,
                                     core::Seconds latest_departure, core::Seconds latest_arrival);

/// When a vehicle may be at a place, within a span. It may stay while it can hold station there; it may only pass
/// while nothing else is in the way.
/// Accuracy  as `can_stay_until`, but the ends of stays are known to a second. Where a current slackens only between
///           two time steps of its data, the vehicle may not stay
[[nodiscard]] std::vector<graph::SafeInterval> safe_intervals(const Sea& sea, geo::PlanePoint place,
                                                              TimeSpan within);

/// The time until which reopenings are considered for a route of this length: the end of the currents, but at most
/// ten days more than the slowest travel takes, because an iceberg may stay for ever.
[[nodiscard]] core::Seconds end_of_looks(const Sea& sea, core::Seconds depart, core::Metres way);

/// Number of closures of a place that are over at `time`: it identifies the interval between closures.
[[nodiscard]] std::size_t interval_of(const std::vector<TimeSpan>& closed, core::Seconds time);

/// Calls `emit(leg)` for the earliest arrival in each interval between closures of the leg's end, as far as a wait at
/// its beginning leads there.
/// `closed_at_end`: when the end of the leg is closed, ascending.
template <class Emit>
void for_each_opening(const Sea& sea, geo::PlanePoint a, geo::PlanePoint b,
                      const std::vector<TimeSpan>& closed_at_end, core::Seconds arrive, core::Seconds latest,
                      Emit&& emit) {
  auto leg = leg_when_open(sea, a, b, arrive, latest);
  if (!leg) return;
  emit(*leg);
  if (sea.holding().longest.count() <= 0.0) return;
  for (const TimeSpan& closed : closed_at_end) {
    const core::Seconds there = arrive + leg->total();
    if (closed.until <= there) continue;
    if (closed.until - leg->time > arrive + sea.holding().longest) return;
    const auto later = leg_when_open(sea, a, b, arrive, latest, closed.until - leg->time);
    if (!later) return;
    if (arrive + later->total() <= closed.until) continue;
    leg = later;
    emit(*leg);
  }
}

}  // namespace floeplan::planning::cost

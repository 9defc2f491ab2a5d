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

/// A leg, and the hold at its beginning before the departure.
struct WaitedLeg {
  core::Seconds wait{};
  core::Seconds time{};  // of travel

  [[nodiscard]] core::Seconds total() const { return wait + time; }
};

/// Whether a hold can get the vehicle past a closure: the request allows holds, and some zone, iceberg or
/// current closes places only for a while.
[[nodiscard]] bool holds_may_help(const Sea& sea);

/// The time until which the vehicle can hold at a place, at most `until`. It can hold as long as it can stay
/// within its circle (hold_circle.hpp) and no timed closure touches the circle.
/// Accuracy  room below the ice is checked every quarter of an hour; currents and closures are exact
[[nodiscard]] core::Seconds can_stay_until(const Sea& sea, geo::PlanePoint place, core::Seconds from,
                                           core::Seconds until);
/// Whether the vehicle can hold from `from` until `until` if timed closures are ignored.
[[nodiscard]] bool current_lets_stay(const Sea& sea, geo::PlanePoint place, core::Seconds from,
                                     core::Seconds until);

/// Tolerance of the shortest wait after a refused departure.
inline constexpr core::Seconds punctual{0.1};

/// Step between tried departures when a leg is clear for a drive at constant speed but closed for the exact
/// drive. A fixed share of the leg's time, at least 30 s.
[[nodiscard]] core::Seconds fineness_of_waits(core::Seconds leg_time);

/// Step between tried departures of a leg that a current closes, for a vehicle that can hold for `stays`.
/// Precondition  the currents change with time
[[nodiscard]] core::Seconds between_tries(const Sea& sea, core::Seconds stays);

/// The leg for a vehicle that reaches its beginning at `arrive`. The vehicle departs at once or after the
/// shortest hold, within the request's limit, until a closure ends or a current slackens.
/// `not_before`: earliest departure, besides the arrival.
/// Errors    as Sea::leg_time, for the departure without a hold
/// Accuracy  that of obstacles::Closures::first_clear_departure; `punctual` if the leg is still closed at
///           that departure and then stays open. A leg that is open for less than `fineness_of_waits`, or a
///           quarter of an hour, may be missed. A leg that a current closed may be missed if it is open for
///           less than `between_tries`
[[nodiscard]] tl::expected<WaitedLeg, motion::EdgeClosed> leg_when_open(
    const Sea& sea, geo::PlanePoint a, geo::PlanePoint b, core::Seconds arrive,
    core::Seconds latest = core::Seconds{INFINITY}, core::Seconds not_before = core::Seconds{0.0});

/// Hold and travel time of `leg_when_open` together.
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

/// Result of one call of `next_open_leg`.
struct OpenLegLook {
  std::optional<OpenLeg> leg;
  core::Seconds looked_until;  // no departure before this time is open
};

/// The first departure within a span at which the leg is open and ends no earlier than `not_before`. One call
/// tries only a few departures. If it finds none, call it again from `looked_until` to continue.
/// Accuracy  as `leg_when_open`. Where a current or ice closes the leg, an open period shorter than a quarter of
///           an hour, or than a quarter of the data's time step, may be missed
[[nodiscard]] OpenLegLook next_open_leg(const Sea& sea, geo::PlanePoint a, geo::PlanePoint b,
                                        TimeSpan departures, core::Seconds not_before);

/// The last departure, at most `latest_departure`, until which the leg stays open from the departure of `leg`
/// on and ends by `latest_arrival`. One call takes only a few steps. Call it again with its result to
/// continue.
/// Accuracy  `punctual`. A closure shorter than five minutes, or than a share of the leg's time, may be
///           missed: the caller times the leg of a departure before it uses it
[[nodiscard]] OpenLeg open_leg_until(const Sea& sea, geo::PlanePoint a, geo::PlanePoint b, const OpenLeg& leg,
                                     core::Seconds latest_departure, core::Seconds latest_arrival);

/// The spans within which a vehicle may be at a place. It may stay in a span while it can hold station;
/// otherwise it may only pass while no closure covers the place.
/// Accuracy  as `can_stay_until`, but the ends of stays are known to a second. Where a current slackens only
///           between two time steps of its data, the vehicle may not stay
[[nodiscard]] std::vector<graph::SafeInterval> safe_intervals(const Sea& sea, geo::PlanePoint place,
                                                              TimeSpan within);

/// The last time at which a reopening counts for a route of this length: the end of the currents, but at most
/// ten days plus the time at the slowest average speed. Without this limit the vehicle would hold for ever at
/// an iceberg that does not move.
[[nodiscard]] core::Seconds end_of_looks(const Sea& sea, core::Seconds depart, core::Metres way);

/// Number of closures of a place that end before `time`. The number identifies the interval between closures.
[[nodiscard]] std::size_t interval_of(const std::vector<TimeSpan>& closed, core::Seconds time);

/// Calls `emit(leg)` for the earliest arrival at the leg's end in each interval between the closures of that
/// end, if a hold at the leg's beginning leads to this arrival.
/// `closed_at_end`: closed times of the leg's end, ascending.
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

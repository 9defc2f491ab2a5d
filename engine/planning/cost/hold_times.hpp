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

/// A leg and how long the vehicle waits at its beginning before it sets out.
struct WaitedLeg {
  core::Seconds wait{};
  core::Seconds time{};  // of the travel

  [[nodiscard]] core::Seconds total() const { return wait + time; }
};

/// Whether a wait may bring the vehicle through what it could not pass before: it has leave to, and zones, icebergs or
/// currents are in its way for a while only.
[[nodiscard]] bool holds_may_help(const Sea& sea);

/// Until when the vehicle can hold at a place where it is at `from`, no later than `until`: as long as it can keep to
/// its circle (hold_circle.hpp) and nothing that closes for a while touches that.
/// Accuracy  room below the ice is looked at every quarter of an hour; the current and what closes the place are exact
[[nodiscard]] core::Seconds can_stay_until(const Sea& sea, geo::PlanePoint place, core::Seconds from,
                                           core::Seconds until);
/// The same as if nothing closed and opened in time.
[[nodiscard]] bool current_lets_stay(const Sea& sea, geo::PlanePoint place, core::Seconds from,
                                     core::Seconds until);

/// To within so much a wait is the least after a departure that was refused.
inline constexpr core::Seconds punctual{0.1};

/// Between the departures that are tried when only the exact drive of a leg is closed, by the time that it takes.
[[nodiscard]] core::Seconds fineness_of_waits(core::Seconds leg_time);

/// Between the departures that are tried until a current slackens, for a vehicle that can stay for so long.
/// Precondition  the currents change
[[nodiscard]] core::Seconds between_tries(const Sea& sea, core::Seconds stays);

/// The leg for a vehicle that is at its beginning at `arrive`: at once, or after the least wait, up to the request's
/// longest, that lets it through what is closed for a while, or against a current that slackens.
/// `not_before`: an earliest departure beside the arrival.
/// Errors    as Sea::leg_time, for the departure at once
/// Accuracy  that of Sea::first_clear_departure, or `punctual` where the leg is still closed then and stays open once
///           it is; one that is open for less than `fineness_of_waits`, or a quarter of an hour, may be overlooked; one
///           that a current closed, if it is open for less than `between_tries`
[[nodiscard]] tl::expected<WaitedLeg, motion::EdgeClosed> leg_when_open(
    const Sea& sea, geo::PlanePoint a, geo::PlanePoint b, core::Seconds arrive,
    core::Seconds latest = core::Seconds{INFINITY}, core::Seconds not_before = core::Seconds{0.0});

/// Its wait and travel together.
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

/// What became of a look for one.
struct OpenLegLook {
  std::optional<OpenLeg> leg;
  core::Seconds looked_until;  // there is none before it
};

/// The first departure of a span at which the leg is open and ends no earlier than at `not_before`. Looks at a few
/// departures only; asked again from where it came to, it goes on.
/// Accuracy  as `leg_when_open`; where a current or ice closes the leg, one that is open for less than a quarter of an
///           hour, or of the data's step in time, may be overlooked
[[nodiscard]] OpenLegLook next_open_leg(const Sea& sea, geo::PlanePoint a, geo::PlanePoint b,
                                        TimeSpan departures, core::Seconds not_before);

/// The last departure, no later than `latest_departure`, such that the leg is open from `leg` to it and ends no later
/// than at `latest_arrival`. Goes on for a few steps only; asked again from there, further.
/// Accuracy  to within `punctual`; a closure that is shorter than five minutes, or a share of the leg's time, may be
///           overlooked: before a departure is used, its leg is timed for itself
[[nodiscard]] OpenLeg open_leg_until(const Sea& sea, geo::PlanePoint a, geo::PlanePoint b, const OpenLeg& leg,
                                     core::Seconds latest_departure, core::Seconds latest_arrival);

/// When a vehicle may be at a place, within a span: it may stay where it can keep its place against the current and
/// below the ice, and pass where nothing is in the way.
/// Accuracy  as `can_stay_until`, but that the ends of stays are known to a second; where a current slackens between
///           two steps of its data only, the vehicle may not stay meanwhile
[[nodiscard]] std::vector<graph::SafeInterval> safe_intervals(const Sea& sea, geo::PlanePoint place,
                                                              TimeSpan within);

/// Until when it is looked for what opens, for a vehicle that goes so far: to the end of the currents, and ten days
/// longer than it takes at most in slack water, because an iceberg may stay for ever.
[[nodiscard]] core::Seconds end_of_looks(const Sea& sea, core::Seconds depart, core::Metres way);

/// Which of a place's times between closures a moment belongs to: how many closures are over by then.
[[nodiscard]] std::size_t interval_of(const std::vector<TimeSpan>& closed, core::Seconds time);

/// Calls `emit(leg)` for the earliest arrival in each of the times between closures of the leg's end, as far as
/// waiting at its beginning leads there.
/// `closed_at_end`: when the leg's end is closed, ascending.
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

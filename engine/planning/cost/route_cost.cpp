#include "engine/planning/cost/route_cost.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "engine/planning/cost/held_schedule.hpp"
#include "engine/planning/cost/hold_times.hpp"
#include "engine/planning/cost/surfacing_watch.hpp"

namespace floeplan::planning::cost {
namespace {

constexpr int pieces_to_locate = 256;  // of a closed leg: the first closed piece is reported

RouteClosed locate(const Sea& sea, geo::PlanePoint from, geo::PlanePoint to, core::Seconds depart,
                   core::Seconds since_surfacing, motion::EdgeClosed reason) {
  geo::PlanePoint here = from;
  core::Seconds now = depart;
  for (int i = 1; i <= pieces_to_locate; ++i) {
    const double share = static_cast<double>(i) / pieces_to_locate;
    const geo::PlanePoint next{from.x_m + share * (to.x_m - from.x_m),
                               from.y_m + share * (to.y_m - from.y_m)};
    const auto leg = sea.leg(here, next, now, since_surfacing);
    if (!leg) {
      const bool out_of_time = leg.error() == motion::EdgeClosed::outside_data &&
                               !sea.domain().safety().closed_between(here, next) &&
                               sea.domain().currents_known_to_end(next, now);
      return {leg.error(), here, now, out_of_time};
    }
    here = next;
    now += leg->time;
    since_surfacing = leg->since_surfacing;
  }
  return {reason, here, now, false};
}

tl::expected<Schedule, RouteClosed> without_waits(const Sea& sea, const std::vector<geo::PlanePoint>& route,
                                                  core::Seconds depart, core::Seconds since_surfacing) {
  std::vector<core::Seconds> arrivals{depart};
  for (std::size_t i = 1; i < route.size(); ++i) {
    const auto leg = sea.leg(route[i - 1], route[i], arrivals.back(), since_surfacing);
    if (!leg) {
      return tl::unexpected(
          locate(sea, route[i - 1], route[i], arrivals.back(), since_surfacing, leg.error()));
    }
    arrivals.push_back(arrivals.back() + leg->time);
    since_surfacing = leg->since_surfacing;
  }
  return Schedule{std::move(arrivals), std::vector<core::Seconds>(route.size())};
}

/// One possible arrival at a point of the route; with holds there may be several.
struct Stage {
  core::Seconds arrival;
  core::Seconds since_surfacing;
  core::Seconds waited{};  // hold at the point before
  std::size_t before{};    // index among the stages of the point before
};

/// Whether stage `other` is needless: a vehicle at stage `first` can hold until `other` arrives and then do
/// the same.
bool replaces(const Sea& sea, geo::PlanePoint point, const std::vector<TimeSpan>& closed, const Stage& first,
              const Stage& other) {
  if (first.arrival > other.arrival || other.arrival - first.arrival > sea.holding().longest) return false;
  if (interval_of(closed, first.arrival) != interval_of(closed, other.arrival)) return false;
  if (!current_lets_stay(sea, point, first.arrival, other.arrival)) return false;
  const auto since_surfacing = since_surfacing_after_wait(sea.domain().overhead(), point, first.arrival,
                                                          other.arrival, first.since_surfacing);
  return since_surfacing && *since_surfacing <= other.since_surfacing;
}

/// The stage at the end of a leg. `stage`: at its beginning. Empty if the time without surfacing would exceed
/// its limit.
std::optional<Stage> stage_after(const Sea& sea, geo::PlanePoint from, geo::PlanePoint to, const Stage& stage,
                                 const WaitedLeg& leg) {
  Stage next{.arrival = stage.arrival + leg.total(), .since_surfacing = {}, .waited = leg.wait};
  if (!sea.domain().overhead().bounds_surfacing()) return next;
  const core::Seconds leaves = stage.arrival + leg.wait;
  const auto waited =
      since_surfacing_after_wait(sea.domain().overhead(), from, stage.arrival, leaves, stage.since_surfacing);
  if (!waited) return std::nullopt;
  const auto drive = sea.leg(from, to, leaves, *waited);
  if (!drive) return std::nullopt;
  next.since_surfacing = drive->since_surfacing;
  return next;
}

/// The earliest schedule with holds. Each point keeps several arrivals, one for each interval between its
/// closures: the earliest arrival is not always best, because the place may close before the next leg opens
/// (safe intervals).
std::optional<Schedule> with_waits(const Sea& sea, const std::vector<geo::PlanePoint>& route,
                                   core::Seconds depart, core::Seconds since_surfacing) {
  constexpr std::size_t most_stages = 16;
  std::vector<std::vector<Stage>> stages{{{.arrival = depart, .since_surfacing = since_surfacing}}};
  for (std::size_t i = 1; i < route.size(); ++i) {
    const std::vector<TimeSpan> closed = sea.domain().closures().closed_times(route[i]);
    std::vector<Stage> here;
    const auto add = [&](const Stage& stage) {
      const auto is_replaced = [&](const Stage& other) {
        return replaces(sea, route[i], closed, other, stage);
      };
      if (here.size() < most_stages && !std::ranges::any_of(here, is_replaced)) here.push_back(stage);
    };
    for (std::size_t s = 0; s < stages.back().size(); ++s) {
      const Stage& stage = stages.back()[s];
      for_each_opening(sea, route[i - 1], route[i], closed, stage.arrival, core::Seconds{INFINITY},
                       [&](const WaitedLeg& leg) {
                         auto next = stage_after(sea, route[i - 1], route[i], stage, leg);
                         if (!next) return;
                         next->before = s;
                         add(*next);
                       });
    }
    if (here.empty()) return std::nullopt;
    stages.push_back(std::move(here));
  }
  Schedule schedule{std::vector<core::Seconds>(route.size()), std::vector<core::Seconds>(route.size())};
  std::size_t best = static_cast<std::size_t>(std::ranges::min_element(stages.back(), {}, &Stage::arrival) -
                                              stages.back().begin());
  for (std::size_t i = route.size(); i-- > 0;) {
    const Stage& stage = stages[i][best];
    schedule.arrivals[i] = stage.arrival;
    if (i > 0) schedule.waits[i - 1] = stage.waited;
    best = stage.before;
  }
  return schedule;
}

}  // namespace

tl::expected<Schedule, RouteClosed> schedule_along(const Sea& sea, const std::vector<geo::PlanePoint>& route,
                                                   core::Seconds depart, core::Seconds since_surfacing) {
  auto at_once = without_waits(sea, route, depart, since_surfacing);
  if (at_once || !holds_may_help(sea)) return at_once;
  auto waited = sea.domain().overhead().bounds_surfacing() ? with_waits(sea, route, depart, since_surfacing)
                                                           : held_schedule(sea, route, depart);
  if (!waited) return at_once;
  return *std::move(waited);
}

core::Seconds earliest_arrival(const Sea& sea, const std::vector<geo::PlanePoint>& stops) {
  core::Seconds earliest = at_departure;
  for (std::size_t i = 1; i < stops.size(); ++i)
    earliest = open_from(sea.domain().closures().closed_times(stops[i]),
                         earliest + sea.least_time(stops[i - 1], stops[i]));
  return earliest;
}

std::optional<core::Seconds> since_surfacing_at_end(const Sea& sea, const std::vector<geo::PlanePoint>& route,
                                                    core::Seconds depart, core::Seconds since_surfacing,
                                                    core::Seconds latest) {
  constexpr core::Seconds rounding{1e-3};  // rounding error of sums of times
  const auto schedule = schedule_along(sea, route, depart, since_surfacing);
  if (!schedule || schedule->arrivals.back() > latest + rounding) return std::nullopt;
  std::optional<core::Seconds> since = since_surfacing;
  for (std::size_t i = 1; i < route.size() && since; ++i) {
    since = since_surfacing_after_wait(sea.domain().overhead(), route[i - 1], schedule->arrivals[i - 1],
                                       schedule->leaves(i - 1), *since);
    if (!since) return std::nullopt;
    const auto leg = sea.leg(route[i - 1], route[i], schedule->leaves(i - 1), *since);
    since = leg ? std::optional{leg->since_surfacing} : std::nullopt;
  }
  return since;
}

tl::expected<std::vector<core::Seconds>, RouteClosed> arrivals_along(
    const Sea& sea, const std::vector<geo::PlanePoint>& route, core::Seconds depart,
    core::Seconds since_surfacing) {
  return schedule_along(sea, route, depart, since_surfacing).map([](Schedule schedule) {
    return std::move(schedule.arrivals);
  });
}

}  // namespace floeplan::planning::cost

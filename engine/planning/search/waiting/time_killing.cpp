#include "engine/planning/search/waiting/time_killing.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "engine/messages/plan_messages.hpp"
#include "engine/planning/cost/loiter.hpp"
#include "engine/planning/search/waiting/latest_departure.hpp"

namespace floeplan::planning::search {
namespace {

constexpr core::Seconds worth_telling{600.0};
constexpr std::size_t most_points_between = 64;  // of a route; parts with more are not looked at

/// Time is killed by way: where less than this share of what it would be in still water is added, other things are
/// at work.
constexpr double least_share_of_way = 0.5;

/// What may be circled away on a way that is flown all the same. A judgement: an hour is one long dive more, and who
/// would turn for longer than travel would rather leave later.
constexpr core::Seconds most_circling{3600.0};
constexpr double most_share_circling = 0.5;

core::Seconds bearable_circling(core::Seconds travel_time) {
  return std::max(most_circling, most_share_circling * travel_time);
}

/// Of an arrival that is no worse: the fineness of the searches.
constexpr core::Seconds just_as_good{60.0};
constexpr double just_as_good_share = 1e-3;

/// Whether the way leads where the vehicle could not have been at some time since its departure.
bool passes_what_has_opened(const cost::Sea& sea, const std::vector<geo::PlanePoint>& way,
                            const std::vector<core::Seconds>& arrivals) {
  for (std::size_t i = 1; i < way.size(); ++i) {
    const std::vector<TimeSpan> closed = sea.closed_times(way[i]);
    if (std::ranges::any_of(closed, [&](const TimeSpan& span) {
          return arrivals.front() < span.until && span.until <= arrivals[i];
        }))
      return true;
  }
  return false;
}

}  // namespace

std::optional<TimeKilled> longest_killing_of_time(const cost::Sea& sea, const cost::Route& planned,
                                                  const cost::Schedule& schedule) {
  if (!sea.has_timed_closures()) return std::nullopt;
  const std::vector<geo::PlanePoint>& route = planned.points;
  std::vector<double> way_m{0.0};
  for (std::size_t i = 1; i < route.size(); ++i)
    way_m.push_back(way_m.back() + geo::distance_m(route[i - 1], route[i]));
  std::optional<TimeKilled> longest;
  for (std::size_t from = 0; from + 2 < route.size(); ++from) {
    for (std::size_t to = from + 2; to < route.size() && to <= from + most_points_between; ++to) {
      if (planned.fixed[to - 1]) break;
      const core::Seconds leaves = schedule.leaves(from);
      const core::Seconds arrives = schedule.arrivals[to];
      const core::Seconds worth = longest ? longest->time : worth_telling;
      const double detour_m = way_m[to] - way_m[from] - geo::distance_m(route[from], route[to]);
      if (detour_m < least_share_of_way * sea.through_water().value * worth.count()) continue;
      const auto straight = sea.leg_time_back(route[from], route[to], arrives, leaves + worth);
      if (!straight || arrives - *straight - leaves <= worth) continue;
      if (cost::can_stay_until(sea, route[from], leaves, arrives - *straight) < arrives - *straight) continue;
      longest = TimeKilled{from, to, arrives - *straight - leaves};
    }
  }
  return longest;
}

std::optional<core::Seconds> opens_at(const cost::Sea& sea, geo::PlanePoint place, core::Seconds when) {
  for (const TimeSpan& closed : sea.closed_times(place)) {
    if (closed.from <= when && when <= closed.until && std::isfinite(closed.until.count()))
      return closed.until;
  }
  return std::nullopt;
}

bool is_bearable(core::Seconds depart, core::Seconds at_once, core::Seconds opens) {
  return opens - at_once <= bearable_circling(opens - depart);
}

std::optional<core::Seconds> end_opens_too_late(const cost::Sea& sea, geo::PlanePoint end,
                                                core::Seconds depart, core::Seconds at_once) {
  if (sea.longest_wait().count() > 0.0) return std::nullopt;
  const auto opens = opens_at(sea, end, at_once);
  if (!opens || is_bearable(depart, at_once, *opens)) return std::nullopt;
  return *opens - at_once;
}

std::optional<core::Seconds> circles_too_long(const cost::Sea& sea, const OpenGrid& open,
                                              const std::vector<geo::PlanePoint>& way, core::Seconds depart,
                                              std::optional<core::Seconds> at_once,
                                              const std::stop_token& stop) {
  if (way.empty() || !sea.has_timed_closures()) return std::nullopt;
  const auto schedule = cost::schedule_along(sea, way, depart);
  if (!schedule) return std::nullopt;
  const core::Seconds arrives = schedule->arrivals.back();
  const core::Seconds most = bearable_circling(arrives - depart);
  const core::Seconds waits =
      std::accumulate(schedule->waits.begin(), schedule->waits.end(), core::Seconds{0.0});
  if (at_once && arrives - waits - *at_once <= most) return std::nullopt;
  if (at_once) {
    const auto opens = opens_at(sea, way.back(), *at_once);
    if (opens && *opens - *at_once - waits > most) return *opens - *at_once - waits;
  }
  if (!passes_what_has_opened(sea, way, schedule->arrivals)) return std::nullopt;
  // Where something opens just before the arrival, times on the film run backwards are a little too long.
  const core::Seconds as_good = arrives + std::max(just_as_good, just_as_good_share * (arrives - depart));
  const auto latest = latest_departure(sea, open, as_good, depart + waits + most, stop);
  if (!latest) return std::nullopt;
  return *latest - depart - waits;
}

messages::Message message_of(const TimeKilled& killed, geo::LonLat from) {
  return messages::plan_message<"way-round-what-opens-later">(killed.from, killed.to,
                                                              killed.time.count() / 3600.0)
      .at(from);
}

}  // namespace floeplan::planning::search

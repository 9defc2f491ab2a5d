#include "engine/planning/cost/held_schedule.hpp"

#include <algorithm>

#include "engine/graph/interval_search.hpp"
#include "engine/planning/cost/hold_times.hpp"
#include "engine/planning/cost/sea_intervals.hpp"

namespace floeplan::planning::cost {
namespace {

/// The route as a graph for `graph::find_earliest_among_intervals`: its points are vertices, each joined with
/// the next.
class Chain {
 public:
  Chain(const Sea& sea, const std::vector<geo::PlanePoint>& route, TimeSpan within)
      : route_{route}, remaining_(route.size()), soonest_(route.size(), within.from), until_{within.until} {
    for (std::size_t i = route.size() - 1; i-- > 0;)
      remaining_[i] = remaining_[i + 1] + sea.least_time(route[i], route[i + 1]);
    for (std::size_t i = 1; i < route.size(); ++i)
      soonest_[i] = within.from + sea.least_time(route.front(), route[i]);
  }

  [[nodiscard]] std::size_t size() const { return route_.size(); }
  [[nodiscard]] static bool is_open(graph::Vertex) { return true; }
  template <class Visit>
  void for_each_edge(graph::Vertex tail, const Visit& visit) const {
    if (tail + 1 < route_.size()) visit(graph::Edge{tail, tail + 1, 0});
  }
  [[nodiscard]] geo::PlanePoint point(graph::Vertex v) const { return route_[v]; }
  [[nodiscard]] core::Seconds least_time(const graph::Edge& edge, core::Seconds) const {
    return remaining_[edge.tail] - remaining_[edge.head];
  }
  [[nodiscard]] core::Seconds remaining(graph::Vertex v) const { return remaining_[v]; }
  [[nodiscard]] TimeSpan of_use(graph::Vertex v) const { return {soonest_[v], until_}; }

 private:
  const std::vector<geo::PlanePoint>& route_;
  std::vector<core::Seconds> remaining_;  // lower bound of the time to the end, for each point
  std::vector<core::Seconds> soonest_;    // lower bound of the arrival at each point
  core::Seconds until_;
};

core::Metres length_of(const std::vector<geo::PlanePoint>& route) {
  core::Metres length{0.0};
  for (std::size_t i = 1; i < route.size(); ++i)
    length = length + core::Metres{geo::distance_m(route[i - 1], route[i])};
  return length;
}

/// The schedule for the visits that the search found. A vehicle that arrives after the departure of its visit
/// leaves at once.
std::optional<Schedule> timed(const Sea& sea, const std::vector<geo::PlanePoint>& route,
                              const std::vector<graph::Visit>& visits) {
  Schedule schedule{{core::Seconds{visits.front().arrive_s}}, {}};
  for (std::size_t i = 0; i + 1 < route.size(); ++i) {
    const bool waits = visits[i].leave_s - visits[i].arrive_s > punctual.count();
    const core::Seconds leaves{visits[i].leave_s};
    const core::Seconds there = schedule.arrivals.back();
    schedule.waits.push_back(waits ? std::max(core::Seconds{0.0}, leaves - there) : core::Seconds{0.0});
    const auto time = sea.leg_time(route[i], route[i + 1], schedule.leaves(i));
    if (!time) return std::nullopt;
    schedule.arrivals.push_back(schedule.leaves(i) + *time);
  }
  schedule.waits.push_back(core::Seconds{0.0});
  return schedule;
}

}  // namespace

core::Seconds longest_hold(const Schedule& schedule, const std::vector<geo::PlanePoint>& route,
                           core::Metres radius) {
  core::Seconds longest{0.0};
  for (std::size_t first = 0; first < route.size(); ++first) {
    if (schedule.waits[first].count() <= 0.0) continue;
    std::size_t last = first;
    for (std::size_t i = first + 1;
         i < route.size() && geo::distance_m(route[first], route[i]) <= radius.value; ++i) {
      if (schedule.waits[i].count() > 0.0) last = i;
    }
    longest = std::max(longest, schedule.leaves(last) - schedule.arrivals[first]);
  }
  return longest;
}

std::optional<Schedule> held_schedule(const Sea& sea, const std::vector<geo::PlanePoint>& route,
                                      core::Seconds depart) {
  if (route.size() < 2) return std::nullopt;
  const core::Seconds end = end_of_looks(sea, depart, length_of(route));
  const Chain chain{sea, route, {depart, end}};
  SeaIntervals model{sea, chain, chain, depart};
  const graph::Query query{0, static_cast<graph::Vertex>(route.size() - 1), depart, end};
  const graph::IntervalSearch search = graph::find_earliest_among_intervals(chain, query, model, {}, {});
  if (search.way.empty()) return std::nullopt;
  auto schedule = timed(sea, route, search.way);
  if (!schedule || longest_hold(*schedule, route, sea.holding().radius) > sea.holding().longest)
    return std::nullopt;
  return schedule;
}

Schedule departing_later(const Sea& sea, const std::vector<geo::PlanePoint>& route, Schedule schedule) {
  constexpr double as_early = 1e-4;  // allowed delay as a share of the travel time: the tolerance of waits
  constexpr core::Seconds fine{60.0};
  const core::Seconds depart = schedule.arrivals.front();
  const core::Seconds latest = schedule.arrivals.back() + as_early * (schedule.arrivals.back() - depart);
  core::Seconds on_the_way{0.0};
  for (std::size_t i = 1; i < schedule.waits.size(); ++i) on_the_way += schedule.waits[i];
  const core::Seconds at_start = schedule.leaves(0);
  const auto leaving = [&](core::Seconds leaves) -> std::optional<Schedule> {
    if (can_stay_until(sea, route.front(), depart, leaves) < leaves) return std::nullopt;
    auto later = held_schedule(sea, route, leaves);
    if (!later || later->arrivals.back() > latest) return std::nullopt;
    later->waits.front() += leaves - depart;
    later->arrivals.front() = depart;
    if (longest_hold(*later, route, sea.holding().radius) > sea.holding().longest) return std::nullopt;
    return later;
  };
  core::Seconds in_time{0.0};
  core::Seconds too_late = on_the_way;
  for (core::Seconds more = on_the_way; too_late - in_time > fine; more = 0.5 * (in_time + too_late)) {
    if (auto later = leaving(at_start + more)) {
      schedule = *std::move(later);
      in_time = more;
    } else {
      too_late = more;
    }
  }
  return schedule;
}

}  // namespace floeplan::planning::cost

#include "engine/planning/cost/held_schedule.hpp"

#include <algorithm>

#include "engine/graph/interval_search.hpp"
#include "engine/planning/cost/hold_times.hpp"
#include "engine/planning/cost/sea_intervals.hpp"

namespace floeplan::planning::cost {
namespace {

/// The points of a route, each joined with the next.
class Chain {
 public:
  Chain(const Sea& sea, const std::vector<geo::PlanePoint>& route) : route_{route}, remaining_(route.size()) {
    for (std::size_t i = route.size() - 1; i-- > 0;)
      remaining_[i] = remaining_[i + 1] + sea.least_time(route[i], route[i + 1]);
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

 private:
  const std::vector<geo::PlanePoint>& route_;
  std::vector<core::Seconds> remaining_;  // to the end, at least
};

core::Metres length_of(const std::vector<geo::PlanePoint>& route) {
  core::Metres length{0.0};
  for (std::size_t i = 1; i < route.size(); ++i)
    length = length + core::Metres{geo::distance_m(route[i - 1], route[i])};
  return length;
}

/// The schedule of a vehicle that leaves each point then, or when it is there where that is later.
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
  const Chain chain{sea, route};
  const core::Seconds end = end_of_looks(sea, depart, length_of(route));
  SeaIntervals model{sea, chain, chain, 0, {depart, end}};
  const graph::Query query{0, static_cast<graph::Vertex>(route.size() - 1), depart, end};
  const graph::IntervalSearch search = graph::find_earliest_among_intervals(chain, query, model, {}, {});
  if (search.way.empty()) return std::nullopt;
  auto schedule = timed(sea, route, search.way);
  if (!schedule || longest_hold(*schedule, route, sea.holding().radius) > sea.holding().longest)
    return std::nullopt;
  return schedule;
}

}  // namespace floeplan::planning::cost

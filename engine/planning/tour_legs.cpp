#include "engine/planning/tour_legs.hpp"

#include <cmath>

#include "engine/graph/label_setting_search.hpp"
#include "engine/planning/grid_travel.hpp"
#include "engine/planning/route_cost.hpp"
#include "engine/planning/route_search.hpp"
#include "engine/planning/time_killing.hpp"

namespace floeplan::planning {
namespace {

constexpr double steps_per_leg = 16.0;               // of the grid: a few milliseconds a search
constexpr core::Seconds between_departures{7200.0};  // a sixth of a half-day tide
constexpr GridReach reach{0.5, 0.25};

}  // namespace

TourLegs::TourLegs(const Sea& sea, const Layout& layout, const PlanRequest& request,
                   const std::stop_token& stop)
    : sea_{sea}, layout_{layout}, request_{request}, stop_{stop} {
  request_.method = Method::astar;
  for (const geo::PlanePoint point : layout.points) closed_.push_back(sea.closed_times(point));
}

TourLegs::Leg& TourLegs::leg(Pair pair) {
  const auto known = legs_.find(pair);
  if (known != legs_.end()) return known->second;
  const geo::PlanePoint from = layout_.points[pair.first];
  const geo::PlanePoint to = layout_.points[pair.second];
  const core::Metres step{geo::distance_m(from, to) / steps_per_leg};
  const RouteGrid grid = lay_grid(from, to, {step, step}, reach);
  return legs_.emplace(pair, Leg{open_grid(sea_, grid, request_.sectors, stop_), {}}).first->second;
}

std::optional<core::Seconds> TourLegs::searched(Leg& leg, long departure) {
  const auto known = leg.times.find(departure);
  if (known != leg.times.end()) return known->second;
  const core::Seconds depart = static_cast<double>(departure) * between_departures;
  const auto time = sea_.bounds_surfacing() ? bounded(leg.open, depart) : unbounded(leg.open, depart);
  if (stop_.stop_requested()) return std::nullopt;
  leg.times.emplace(departure, time);
  return time;
}

std::optional<core::Seconds> TourLegs::bounded(const OpenGrid& open, core::Seconds depart) const {
  const RouteSearch search = search_route(sea_, open, request_, depart, stop_, [](double) {});
  if (search.path.empty()) return std::nullopt;
  const auto arrivals = arrivals_along(sea_, search.path, depart);
  return arrivals ? std::optional{arrivals->back() - depart} : std::nullopt;
}

std::optional<core::Seconds> TourLegs::unbounded(const OpenGrid& open, core::Seconds depart) const {
  const graph::Query query{
      .source = open.grid.start, .goal = open.grid.goal, .depart = depart, .latest = core::Seconds{INFINITY}};
  const StraightBound straight{sea_, open.grid, open.graph, open.grid.goal};
  const auto search = [&](const auto& travel_time) {
    return graph::find_earliest_arrivals(open.graph, query, travel_time, stop_, straight);
  };
  // Only the search that minds the time minds what ice leaves no room; yet icebergs then close places, too.
  std::optional<graph::SearchTree> tree;
  if (sea_.ice()) tree = search(GridTravelTime{sea_, open.grid});
  if (!tree || (sea_.has_timed_closures() && !tree->is_reached(open.grid.goal)))
    tree = search(UntimedTravelTime{sea_, open.grid});
  if (!tree->is_reached(open.grid.goal)) return std::nullopt;
  return core::Seconds{tree->arrival_s(open.grid.goal)} - depart;
}

std::optional<core::Seconds> TourLegs::time_under_way(std::size_t from, std::size_t to,
                                                      core::Seconds depart) {
  if (stop_.stop_requested()) return std::nullopt;
  const geo::PlanePoint a = layout_.points[from];
  const geo::PlanePoint b = layout_.points[to];
  if (a.x_m == b.x_m && a.y_m == b.y_m) return core::Seconds{0.0};
  Leg& on_grid = leg({from, to});
  const double position = depart / between_departures;
  const auto before = static_cast<long>(std::floor(position));
  const auto early = searched(on_grid, before);
  const auto late = searched(on_grid, before + 1);
  // Where only one of the two departures has a way, at the end of the data for instance, it stands for both.
  if (!early && !late) return std::nullopt;
  const core::Seconds first = early ? *early : *late;
  const core::Seconds last = late ? *late : *early;
  return first + (position - static_cast<double>(before)) * (last - first);
}

std::optional<core::Seconds> TourLegs::time(std::size_t from, std::size_t to, core::Seconds depart) {
  const auto under_way = time_under_way(from, to, depart);
  if (!under_way) return std::nullopt;
  return when_open(to, depart + *under_way) - depart;
}

std::optional<core::Seconds> TourLegs::bearable_time(std::size_t from, std::size_t to, core::Seconds depart) {
  const auto under_way = time_under_way(from, to, depart);
  if (!under_way) return std::nullopt;
  const core::Seconds arrival = depart + *under_way;
  const core::Seconds opens = when_open(to, arrival);
  const bool may_wait = sea_.longest_wait().count() > 0.0;
  if (!may_wait && !is_bearable(depart, arrival, opens)) return std::nullopt;
  return opens - depart;
}

core::Seconds TourLegs::when_open(std::size_t place, core::Seconds arrival) const {
  for (const TimeSpan& closed : closed_[place])
    if (closed.from <= arrival && arrival < closed.until) arrival = closed.until;
  return arrival;
}

}  // namespace floeplan::planning

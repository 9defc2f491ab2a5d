#include "engine/planning/planner/tour_legs.hpp"

#include <algorithm>
#include <cmath>

#include "engine/graph/time_dependent_astar.hpp"
#include "engine/planning/cost/route_cost.hpp"
#include "engine/planning/planner/visiting_order.hpp"
#include "engine/planning/search/grid/grid_travel.hpp"
#include "engine/planning/search/route_search.hpp"

namespace floeplan::planning::planner {
namespace {

// Grid steps between two stops. A search takes some tens of milliseconds. With many places every pair is
// searched, so coarser grids are used; a search then takes a few milliseconds.
constexpr double steps_per_leg = 16.0;
constexpr double steps_of_many = 10.0;
constexpr int most_sectors_of_many = 2;
constexpr core::Seconds between_departures{7200.0};  // a sixth of a semidiurnal tide
constexpr cost::GridReach reach{0.5, 0.25};
constexpr long departures_between_searches = 6;  // twelve hours: about a semidiurnal tide
constexpr core::Seconds just_after{1.0};         // after the end of a closure, which is still closed

}  // namespace

TourLegs::TourLegs(const cost::Sea& sea, const cost::Layout& layout, const PlanRequest& request,
                   const std::stop_token& stop)
    : sea_{sea},
      layout_{layout},
      request_{request},
      has_many_places_{layout.points.size() > most_places_ordered_exactly + 2},
      stop_{stop} {
  request_.method = Method::astar;
  if (has_many_places_) request_.sectors = std::min(request_.sectors, most_sectors_of_many);
  for (const geo::PlanePoint point : layout.points)
    closed_.push_back(sea.domain().closures().closed_times(point));
}

TourLegs::Leg& TourLegs::leg(Pair pair) {
  const auto known = legs_.find(pair);
  if (known != legs_.end()) return known->second;
  const geo::PlanePoint from = layout_.points[pair.first];
  const geo::PlanePoint to = layout_.points[pair.second];
  const core::Metres step{geo::distance_m(from, to) / (has_many_places_ ? steps_of_many : steps_per_leg)};
  const cost::RouteGrid grid = cost::lay_grid(from, to, {step, step}, reach);
  return legs_.emplace(pair, Leg{.open = search::open_grid(sea_.domain(), grid, request_.sectors, stop_)})
      .first->second;
}

std::optional<TourLegs::Way> TourLegs::way_at(Pair pair, long departure) {
  Leg& on_grid = leg(pair);
  const auto known = on_grid.ways.find(departure);
  if (known != on_grid.ways.end()) return known->second;
  const core::Seconds depart = static_cast<double>(departure) * between_departures;
  std::optional<Way> way;
  const long since_search =
      (departure % departures_between_searches + departures_between_searches) % departures_between_searches;
  if (has_many_places_ && since_search != 0 && !sea_.domain().overhead().bounds_surfacing()) {
    const long before = departure - since_search;
    for (const long other : {before, before + departures_between_searches}) {
      const auto found = way_at(pair, other);
      auto same = found ? followed(*found, pair.second, depart) : std::nullopt;
      if (same && (!way || same->time < way->time)) way = std::move(same);
    }
  }
  if (!way) way = searched(on_grid, depart);
  if (stop_.stop_requested()) return std::nullopt;
  return on_grid.ways.emplace(departure, std::move(way)).first->second;
}

std::optional<TourLegs::Way> TourLegs::searched(Leg& leg, core::Seconds depart) const {
  return sea_.domain().overhead().bounds_surfacing() ? bounded(leg.open, depart) : unbounded(leg, depart);
}

std::optional<TourLegs::Way> TourLegs::followed(const Way& way, std::size_t to, core::Seconds depart) const {
  const auto end_by = [&](auto leg_time) -> std::optional<core::Seconds> {
    core::Seconds now = depart;
    for (std::size_t i = 1; i < way.path.size(); ++i) {
      const auto time = leg_time(way.path[i - 1], way.path[i], now);
      if (!time) return std::nullopt;
      now += *time;
    }
    return now;
  };
  if (way.is_past_closures) {
    const auto end = end_by(
        [&](geo::PlanePoint a, geo::PlanePoint b, core::Seconds now) { return sea_.leg_time(a, b, now); });
    if (end) return Way{*end - depart, way.path, true};
  }
  const auto end = end_by([&](geo::PlanePoint a, geo::PlanePoint b, core::Seconds now) {
    return sea_.leg_time_without_timed_closures(a, b, now, core::Seconds{INFINITY});
  });
  if (!end) return std::nullopt;
  // If only the end is closed on arrival, the vehicle waits for it. If the route is closed elsewhere, another
  // route is needed.
  const bool waits_at_end = open_from(closed_[to], *end) > *end;
  if (way.is_past_closures && !waits_at_end) return std::nullopt;
  return Way{*end - depart, way.path, false};
}

template <class TravelTime>
graph::SearchTree TourLegs::earliest_arrivals(Leg& leg, core::Seconds depart,
                                              const TravelTime& travel_time) const {
  const search::OpenGrid& open = leg.open;
  const graph::Query query{
      .source = open.grid.start, .goal = open.grid.goal, .depart = depart, .latest = core::Seconds{INFINITY}};
  // With many places few departures are tried, so a sharper bound for each pair would cost more than it
  // saves.
  if (!has_many_places_)
    return graph::find_earliest_arrivals(open.graph, query, travel_time, stop_, bound_of(leg));
  const search::StraightBound straight{sea_, open.grid, open.graph, open.grid.goal};
  return graph::find_earliest_arrivals(open.graph, query, travel_time, stop_, straight);
}

const search::FavourableBound& TourLegs::bound_of(Leg& leg) const {
  if (!leg.bound) leg.bound.emplace(search::FavourableGrid{sea_, leg.open}, search::RouteEnd::goal, stop_);
  return *leg.bound;
}

core::Seconds TourLegs::usual_time(std::size_t from, std::size_t to) {
  const geo::PlanePoint a = layout_.points[from];
  const geo::PlanePoint b = layout_.points[to];
  if (stop_.stop_requested() || (a.x_m == b.x_m && a.y_m == b.y_m)) return core::Seconds{0.0};
  const auto way = way_at({from, to}, 0);
  return way ? way->time : sea_.domain().lengths().between(a, b) / sea_.through_water();
}

core::Seconds TourLegs::least_time(std::size_t from, std::size_t to) {
  const geo::PlanePoint a = layout_.points[from];
  const geo::PlanePoint b = layout_.points[to];
  if (stop_.stop_requested() || (a.x_m == b.x_m && a.y_m == b.y_m)) return core::Seconds{0.0};
  Leg& on_grid = leg({from, to});
  return bound_of(on_grid).remaining(on_grid.open.grid.start);
}

std::optional<TourLegs::Way> TourLegs::bounded(const search::OpenGrid& open, core::Seconds depart) const {
  search::RouteSearch search = search::search_route(sea_, open, request_, depart, stop_, [](double) {});
  if (search.path.empty()) return std::nullopt;
  const auto arrivals = cost::arrivals_along(sea_, search.path, depart);
  if (!arrivals) return std::nullopt;
  return Way{arrivals->back() - depart, std::move(search.path)};
}

std::optional<TourLegs::Way> TourLegs::unbounded(Leg& leg, core::Seconds depart) const {
  const search::OpenGrid& open = leg.open;
  // With ice, only the search with all closures finds where ice leaves no room. Icebergs then close places,
  // too; if they leave no route, the search is repeated without closures that end.
  std::optional<graph::SearchTree> tree;
  if (sea_.domain().ice()) tree = earliest_arrivals(leg, depart, search::GridTravelTime{sea_, open.grid});
  const bool is_past_closures = tree && tree->is_reached(open.grid.goal);
  if (!tree || (sea_.domain().closures().any_timed() && !is_past_closures))
    tree = earliest_arrivals(leg, depart, search::UntimedTravelTime{sea_, open.grid});
  if (!tree->is_reached(open.grid.goal)) return std::nullopt;
  Way way{core::Seconds{tree->arrival_s(open.grid.goal)} - depart, {}, is_past_closures};
  for (const graph::Vertex v : graph::path_to(open.graph, *tree, open.grid.goal))
    way.path.push_back(open.grid.point(v));
  return way;
}

std::optional<core::Seconds> TourLegs::time_under_way(std::size_t from, std::size_t to,
                                                      core::Seconds depart) {
  if (stop_.stop_requested()) return std::nullopt;
  const geo::PlanePoint a = layout_.points[from];
  const geo::PlanePoint b = layout_.points[to];
  if (a.x_m == b.x_m && a.y_m == b.y_m) return core::Seconds{0.0};
  const double position = depart / between_departures;
  const auto before = static_cast<long>(std::floor(position));
  const auto early = way_at({from, to}, before);
  const auto late = way_at({from, to}, before + 1);
  // If only one of the two departures has a route, for instance at the end of the data, its time is used for
  // both.
  if (!early && !late) return std::nullopt;
  const core::Seconds first = early ? early->time : late->time;
  const core::Seconds last = late ? late->time : early->time;
  return first + (position - static_cast<double>(before)) * (last - first);
}

std::optional<core::Seconds> TourLegs::time(std::size_t from, std::size_t to, core::Seconds depart) {
  const auto under_way = time_under_way(from, to, depart);
  if (!under_way) return std::nullopt;
  return open_from(closed_[to], depart + *under_way) - depart;
}

std::optional<core::Seconds> TourLegs::time_past_closures(std::size_t from, std::size_t to,
                                                          core::Seconds depart) {
  const auto under_way = time_under_way(from, to, depart);
  if (!under_way) return std::nullopt;
  const core::Seconds arrival = depart + *under_way;
  const core::Seconds opens = open_from(closed_[to], arrival);
  const bool may_hold = sea_.holding().longest.count() > 0.0;
  if (!may_hold && opens > arrival) return std::nullopt;
  // Ways with a bound on the time without surfacing are searched with everything that closes and reopens.
  if (!sea_.domain().closures().any_timed() || sea_.domain().overhead().bounds_surfacing() ||
      arrival == depart)
    return opens - depart;
  const auto arrives = arrival_past_closures({from, to}, depart, arrival, opens);
  return arrives ? std::optional{*arrives - depart} : std::nullopt;
}

std::optional<core::Seconds> TourLegs::arrival_past_closures(Pair pair, core::Seconds depart,
                                                             core::Seconds at_once, core::Seconds opens) {
  Leg& on_grid = leg(pair);
  const core::Seconds leaves = depart + just_after;
  const auto slot = static_cast<long>(std::floor(depart / between_departures));
  core::Seconds arrives{INFINITY};
  for (const long departure : {slot, slot + 1}) {
    const auto way = way_at(pair, departure);
    const auto schedule =
        way ? cost::schedule_along(sea_, way->path, leaves) : tl::unexpected(cost::RouteClosed{});
    if (schedule) arrives = std::min(arrives, schedule->arrivals.back());
  }
  if (arrives <= at_once + between_departures) return std::max(arrives, opens);
  const search::OpenGrid& open = on_grid.open;
  const graph::SearchTree tree = earliest_arrivals(on_grid, leaves, search::GridTravelTime{sea_, open.grid});
  if (stop_.stop_requested()) return std::nullopt;
  arrives = std::min(arrives, core::Seconds{tree.arrival_s(open.grid.goal)});
  if (std::isfinite(arrives.count())) return arrives;
  // If the vehicle can wait somewhere that stays open until the end opens, its arrival is that opening.
  if (!(opens > at_once) || !std::isfinite(opens.count())) return std::nullopt;
  for (graph::Vertex v = 0; v < open.graph.size(); ++v) {
    if (!tree.is_reached(v)) continue;
    const core::Seconds there{tree.arrival_s(v)};
    const bool stays_open = std::ranges::none_of(
        sea_.domain().closures().closed_times(open.grid.point(v)),
        [&](const TimeSpan& closed) { return closed.from <= opens && there <= closed.until; });
    if (stays_open) return opens;
  }
  return std::nullopt;
}

}  // namespace floeplan::planning::planner

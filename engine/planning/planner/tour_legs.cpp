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

constexpr double steps_per_leg = 16.0;               // of the grid: a few milliseconds a search
constexpr core::Seconds between_departures{7200.0};  // a sixth of a half-day tide
constexpr cost::GridReach reach{0.5, 0.25};
constexpr core::Seconds just_after{1.0};  // the end of a closure, which still belongs to it

}  // namespace

TourLegs::TourLegs(const cost::Sea& sea, const cost::Layout& layout, const PlanRequest& request,
                   const std::stop_token& stop)
    : sea_{sea}, layout_{layout}, request_{request}, stop_{stop} {
  request_.method = Method::astar;
  for (const geo::PlanePoint point : layout.points) closed_.push_back(sea.closures().closed_times(point));
}

TourLegs::Leg& TourLegs::leg(Pair pair) {
  const auto known = legs_.find(pair);
  if (known != legs_.end()) return known->second;
  const geo::PlanePoint from = layout_.points[pair.first];
  const geo::PlanePoint to = layout_.points[pair.second];
  const core::Metres step{geo::distance_m(from, to) / steps_per_leg};
  const cost::RouteGrid grid = cost::lay_grid(from, to, {step, step}, reach);
  return legs_.emplace(pair, Leg{.open = search::open_grid(sea_, grid, request_.sectors, stop_)})
      .first->second;
}

std::optional<TourLegs::Way> TourLegs::searched(Leg& leg, long departure) {
  const auto known = leg.ways.find(departure);
  if (known != leg.ways.end()) return known->second;
  const core::Seconds depart = static_cast<double>(departure) * between_departures;
  auto way = sea_.overhead().bounds_surfacing() ? bounded(leg.open, depart) : unbounded(leg, depart);
  if (stop_.stop_requested()) return std::nullopt;
  return leg.ways.emplace(departure, std::move(way)).first->second;
}

template <class TravelTime>
graph::SearchTree TourLegs::earliest_arrivals(Leg& leg, core::Seconds depart,
                                              const TravelTime& travel_time) const {
  const search::OpenGrid& open = leg.open;
  const graph::Query query{
      .source = open.grid.start, .goal = open.grid.goal, .depart = depart, .latest = core::Seconds{INFINITY}};
  // With many places few departures are tried. Then a bound of each pair would take more time than it saves.
  if (layout_.points.size() <= most_places_ordered_exactly + 2)
    return graph::find_earliest_arrivals(open.graph, query, travel_time, stop_, bound_of(leg));
  const search::StraightBound straight{sea_, open.grid, open.graph, open.grid.goal};
  return graph::find_earliest_arrivals(open.graph, query, travel_time, stop_, straight);
}

const search::FavourableBound& TourLegs::bound_of(Leg& leg) const {
  if (!leg.bound) leg.bound.emplace(sea_, leg.open, stop_);
  return *leg.bound;
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
  // Only the search for the time avoids places where ice leaves no room. But then icebergs close places, too.
  std::optional<graph::SearchTree> tree;
  if (sea_.ice()) tree = earliest_arrivals(leg, depart, search::GridTravelTime{sea_, open.grid});
  if (!tree || (sea_.closures().any_timed() && !tree->is_reached(open.grid.goal)))
    tree = earliest_arrivals(leg, depart, search::UntimedTravelTime{sea_, open.grid});
  if (!tree->is_reached(open.grid.goal)) return std::nullopt;
  Way way{core::Seconds{tree->arrival_s(open.grid.goal)} - depart, {}};
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
  Leg& on_grid = leg({from, to});
  const double position = depart / between_departures;
  const auto before = static_cast<long>(std::floor(position));
  const auto early = searched(on_grid, before);
  const auto late = searched(on_grid, before + 1);
  // If only one of the two departures has a way, for instance at the end of the data, it is used for both.
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
  if (!sea_.closures().any_timed() || sea_.overhead().bounds_surfacing() || arrival == depart)
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
    const auto way = searched(on_grid, departure);
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
  // A vehicle can wait at a place that stays open until the end opens, and is then at the end.
  if (!(opens > at_once) || !std::isfinite(opens.count())) return std::nullopt;
  for (graph::Vertex v = 0; v < open.graph.size(); ++v) {
    if (!tree.is_reached(v)) continue;
    const core::Seconds there{tree.arrival_s(v)};
    const bool stays_open = std::ranges::none_of(
        sea_.closures().closed_times(open.grid.point(v)),
        [&](const TimeSpan& closed) { return closed.from <= opens && there <= closed.until; });
    if (stays_open) return opens;
  }
  return std::nullopt;
}

}  // namespace floeplan::planning::planner

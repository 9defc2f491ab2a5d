#include "engine/planning/search/bounds/foresight.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/graph/time_dependent_astar.hpp"

namespace floeplan::planning::search {
namespace {

constexpr double slowest_share = 0.6;  // share of the speed through water: slower counts as this fast
constexpr double least_share =
    0.1;  // the same for estimates: no edge counts as slower, closed ones count as this slow
constexpr double most_share = 0.95;  // also a share: a weaker current leaves every course open
/// Integrated times may be shorter than the true ones by their tolerance. This error shifts the departures of
/// later edges, so the sum of errors may be a few times as large. The bounds are lowered by this number of
/// tolerances.
constexpr double tolerances = 5.0;
/// Closures are taken to be shorter by this at both ends: more than the error of integrated times.
constexpr core::Seconds border{5.0};
/// Estimates wait no longer than this for what closes the middle of an edge alone: it is smaller than the edge. A
/// judgement.
constexpr core::Seconds longest_wait{2.0 * 3600.0};

std::vector<geo::PlanePoint> edges_of(const OpenGrid& open) {
  std::vector<geo::PlanePoint> edges;
  for (const graph::Offset offset : open.graph.offsets()) {
    edges.push_back({offset.dx * open.grid.along.x_m + offset.dy * open.grid.across.x_m,
                     offset.dx * open.grid.along.y_m + offset.dy * open.grid.across.y_m});
  }
  return edges;
}

/// Edge travel times for a search. All edges out of a vertex are timed when the first of them is asked for.
template <class TimeFan>
class FanTravelTime {
 public:
  explicit FanTravelTime(const TimeFan& time_fan) : time_fan_{time_fan} {}

  std::optional<core::Seconds> operator()(const graph::Edge& edge, core::Seconds depart,
                                          core::Seconds latest) const {
    const bool is_new = edge.tail != tail_;
    tail_ = edge.tail;
    return time_fan_(edge, depart, latest, is_new);
  }

 private:
  const TimeFan& time_fan_;
  mutable graph::Vertex tail_{Foresight::no_vertex};
};

/// Bound for a search that ends at `latest`: nobody is of use at a vertex from which one end of the route cannot be
/// reached by then. The order stays that of arrivals, because the bounds are not consistent with those of the edges.
struct InTime {
  const StraightBound& straight;
  const FavourableBound& to_end;
  core::Seconds latest;

  [[nodiscard]] core::Seconds least_time(const graph::Edge& edge, core::Seconds) const {
    return straight.least_time(edge);
  }
  [[nodiscard]] static core::Seconds remaining(graph::Vertex) { return core::Seconds{0.0}; }
  [[nodiscard]] core::Seconds latest_use(graph::Vertex v) const {
    return latest + core::Seconds{rounding_of_times_s} - to_end.remaining(v);
  }
};

/// Bound for the time-reversed search, whose clock shows -t: no vehicle is at a vertex before its earliest
/// arrival.
struct NotBefore {
  const StraightBound& straight;
  const graph::SearchTree& earliest;

  [[nodiscard]] core::Seconds least_time(const graph::Edge& edge, core::Seconds) const {
    return straight.least_time(edge);
  }
  [[nodiscard]] static core::Seconds remaining(graph::Vertex) { return core::Seconds{0.0}; }
  [[nodiscard]] core::Seconds latest_use(graph::Vertex v) const {
    return core::Seconds{rounding_of_times_s - earliest.arrival_s(v)};
  }
};

}  // namespace

Foresight::Foresight(const cost::Sea& sea, const OpenGrid& open, const FavourableBounds* at_any_time)
    : sea_{sea},
      open_{open},
      straight_{sea, open.grid, open.graph, open.grid.goal},
      fan_{edges_of(open)},
      through_water_{std::max(sea.speed(sea.drives().front()), sea.speed(sea.drives().back()))},
      closures_{sea.domain().closures(), open.grid},
      at_any_time_{at_any_time} {
  longest_edge_ = core::Metres{static_cast<double>(std::ranges::max(fan_.length_m))};
  longest_drive_ = longest_edge_ / (slowest_share * through_water_);
  if (sea.domain().currents()) nearby_.emplace(*sea.domain().currents(), longest_edge_, longest_drive_);
}

std::optional<motion::NearbyCurrent> Foresight::water_at(graph::Vertex v, core::Seconds time,
                                                         currents::NearbyCurrents::Film film) {
  if (!is_useful()) return std::nullopt;
  if (nearby_) return nearby_->on_film(open_.grid.point(v), time, film);
  motion::NearbyCurrent still;
  still.known_s = std::numeric_limits<float>::infinity();
  return still;
}

bool Foresight::look(graph::Vertex v, core::Seconds time, currents::NearbyCurrents::Film film,
                     Fidelity fidelity) {
  tail_ = no_vertex;
  const auto near = water_at(v, time, film);
  if (!near) return false;
  const motion::FanVehicle vehicle{
      .through_water_m_s = static_cast<float>(through_water_.value),
      .ground_per_plane =
          static_cast<float>(sea_.domain().lengths().least_per_plane(open_.grid.point(v), longest_edge_)),
      .longest_s = static_cast<float>(longest_drive_.count()),
      .never_stopped =
          !sea_.domain().currents() || sea_.domain().currents()->strongest() < most_share * through_water_};
  if (fidelity == Fidelity::estimate) {
    motion::estimate_fan(fan_, *near, vehicle, times_);
  } else {
    motion::bound_fan(fan_, *near, vehicle, times_);
  }
  return true;
}

const motion::FanTimes* Foresight::estimates(graph::Vertex v, core::Seconds depart, vehicle::Drive drive) {
  tail_ = no_vertex;
  const auto near = water_at(v, depart, currents::NearbyCurrents::Film::forwards);
  if (!near) return nullptr;
  const core::MetresPerSecond speed = sea_.speed(drive);
  const motion::FanVehicle vehicle{
      .through_water_m_s = static_cast<float>(speed.value),
      .ground_per_plane =
          static_cast<float>(sea_.domain().lengths().least_per_plane(open_.grid.point(v), longest_edge_)),
      .longest_s = static_cast<float>((longest_edge_ / (least_share * speed)).count())};
  motion::estimate_fan(fan_, *near, vehicle, times_);
  return &times_;
}

core::Seconds Foresight::open_from(graph::Vertex v, core::Seconds time) {
  for (const TimeSpan& closed : closures_.at(v)) {
    if (closed.from + border < time && time < closed.until - border) return closed.until - border;
  }
  return time;
}

std::vector<graph::Edge> Foresight::likely_way(core::Seconds depart, const std::stop_token& stop,
                                               const Minding& minding) {
  const cost::RouteGrid& grid = open_.grid;
  std::vector<graph::Vertex> barred;
  for (const graph::Edge& edge : minding.closed) {
    for (const graph::Vertex v : {edge.tail, edge.head})
      if (v != grid.start && v != grid.goal) barred.push_back(v);
  }
  const auto is_barred = [&](const graph::Edge& edge) {
    return std::ranges::find(barred, edge.head) != barred.end() ||
           std::ranges::any_of(minding.closed, [&](const graph::Edge& closed) {
             return closed.tail == edge.tail && closed.step == edge.step;
           });
  };
  // The time of a leg that ends before `latest`, with what the closures on its way add to it.
  const auto with_closures = [&](const graph::Edge& edge, core::Seconds now, core::Seconds time,
                                 core::Seconds latest) -> std::optional<core::Seconds> {
    const geo::PlanePoint tail = grid.point(edge.tail);
    const geo::PlanePoint head = grid.point(edge.head);
    const obstacles::Closures& closures = sea_.domain().closures();
    if (is_barred(edge) || closures.closed_between(tail, head)) return std::nullopt;
    if (minding.timed == TimedClosures::ignored) return time;
    const bool may_wait = minding.timed == TimedClosures::waited_for;
    if (may_wait) {
      const core::Seconds open = open_from(edge.head, now + time);
      if (open > now + time) return open - now;
    }
    const core::Seconds last = may_wait ? std::min(latest - time, now + longest_wait) : now;
    const auto clear = closures.first_clear_departure(tail, head, time, now, last);
    return clear ? std::optional{*clear + time - now} : std::nullopt;
  };
  bool is_known = false;
  const auto time_fan = [&](const graph::Edge& edge, core::Seconds now, core::Seconds latest,
                            bool is_new) -> std::optional<core::Seconds> {
    if (is_new) is_known = look(edge.tail, now, currents::NearbyCurrents::Film::forwards, Fidelity::estimate);
    const core::Seconds time{static_cast<double>(times_.time_s[edge.step])};
    if (!is_known || now + time >= latest) return std::nullopt;
    const auto in_all = with_closures(edge, now, time, latest);
    return in_all && now + *in_all < latest ? in_all : std::nullopt;
  };
  const graph::SearchTree tree =
      graph::find_earliest_arrivals(open_.graph, graph::Query{grid.start, grid.goal, depart},
                                    FanTravelTime{time_fan}, stop, at_any_time(stop).to_goal);
  std::vector<graph::Edge> way;
  const std::vector<graph::Vertex> path = graph::path_to(open_.graph, tree, grid.goal);
  for (std::size_t i = 1; i < path.size(); ++i) way.push_back({path[i - 1], path[i], tree.step(path[i])});
  return way;
}

core::Seconds Foresight::proven(const graph::Edge& edge, bool is_known) const {
  const core::Seconds least = straight_.least_time(edge);
  if (!is_known) return least;
  const double share = 1.0 - tolerances * sea_.edge_tolerance();
  return std::max(least, core::Seconds{share * static_cast<double>(times_.time_s[edge.step])});
}

core::Seconds Foresight::least_time(const graph::Edge& edge, core::Seconds depart) {
  if (edge.tail != tail_) {
    tail_is_known_ = look(edge.tail, depart, currents::NearbyCurrents::Film::forwards, Fidelity::bound);
    tail_ = edge.tail;
  }
  return proven(edge, tail_is_known_);
}

const graph::SearchTree& Foresight::until_when_of_use(core::Seconds depart, core::Seconds arrive,
                                                      const std::stop_token& stop) {
  if (!found_ || depart < found_->depart || arrive > found_->arrive) {
    found_.emplace(Found{depart, arrive, sweep_back(depart, arrive, stop)});
  }
  return found_->until_when;
}

graph::SearchTree Foresight::sweep_forth(core::Seconds depart, core::Seconds arrive,
                                         const std::stop_token& stop) {
  const cost::RouteGrid& grid = open_.grid;
  bool is_known = false;
  const auto time_fan = [&](const graph::Edge& edge, core::Seconds now, core::Seconds latest,
                            bool is_new) -> std::optional<core::Seconds> {
    if (is_new) is_known = look(edge.tail, now, currents::NearbyCurrents::Film::forwards, Fidelity::bound);
    const core::Seconds there = now + proven(edge, is_known);
    if (there >= latest) return std::nullopt;
    const core::Seconds open = open_from(edge.head, there);
    if (open >= latest ||
        sea_.domain().closures().closed_between(grid.point(edge.tail), grid.point(edge.head)))
      return std::nullopt;
    return open - now;
  };
  const graph::Query query{.source = grid.start, .goal = {}, .depart = depart, .latest = arrive};
  return graph::find_earliest_arrivals(open_.graph, query, FanTravelTime{time_fan}, stop,
                                       InTime{straight_, at_any_time(stop).to_goal, arrive});
}

graph::SearchTree Foresight::sweep_back(core::Seconds depart, core::Seconds arrive,
                                        const std::stop_token& stop) {
  return sweep_back(depart, arrive, stop, false, InTime{straight_, at_any_time(stop).from_start, -depart});
}

graph::SearchTree Foresight::sweep_back(core::Seconds depart, core::Seconds arrive,
                                        const std::stop_token& stop, const graph::SearchTree& earliest) {
  return sweep_back(depart, arrive, stop, true, NotBefore{straight_, earliest});
}

template <class Bound>
graph::SearchTree Foresight::sweep_back(core::Seconds depart, core::Seconds arrive,
                                        const std::stop_token& stop, bool closures_count,
                                        const Bound& bound) {
  const cost::RouteGrid& grid = open_.grid;
  // No vehicle is at a closed vertex: its latest useful time is then the beginning of the closure.
  const auto when_open = [&](graph::Vertex v, core::Seconds film_time) {
    if (!closures_count) return film_time;
    for (const TimeSpan& closed : closures_.at(v)) {
      const bool is_closed = closed.from + border < -film_time && -film_time < closed.until - border;
      if (is_closed) return -(closed.from + border);
    }
    return film_time;
  };
  bool is_known = false;
  const auto time_fan = [&](const graph::Edge& edge, core::Seconds film_time, core::Seconds latest,
                            bool is_new) -> std::optional<core::Seconds> {
    if (is_new)
      is_known = look(edge.tail, -film_time, currents::NearbyCurrents::Film::backwards, Fidelity::bound);
    core::Seconds time = proven(edge, is_known);
    if (film_time + time >= latest) return std::nullopt;
    time = when_open(edge.head, film_time + time) - film_time;
    if (film_time + time >= latest) return std::nullopt;
    if (sea_.domain().closures().closed_between(grid.point(edge.head), grid.point(edge.tail)))
      return std::nullopt;
    return time;
  };
  const graph::Query query{
      .source = grid.goal, .goal = {}, .depart = when_open(grid.goal, -arrive), .latest = -depart};
  return graph::find_earliest_arrivals(open_.graph, query, FanTravelTime{time_fan}, stop, bound);
}

}  // namespace floeplan::planning::search

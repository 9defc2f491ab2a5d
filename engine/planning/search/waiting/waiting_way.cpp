#include "engine/planning/search/waiting/waiting_way.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>

#include "engine/core/units.hpp"
#include "engine/graph/label_setting_search.hpp"
#include "engine/planning/cost/loiter.hpp"
#include "engine/planning/cost/route_cost.hpp"
#include "engine/planning/search/grid/grid_travel.hpp"

namespace floeplan::planning::search {
namespace {

constexpr int halvings_of_a_wait = 12;
constexpr double near_enough = 5e-4;  // of the travel time, half of what later searches would gain at least
constexpr std::size_t most_places = 8;
constexpr double between_places = 1.0 / 16.0;                // of the time from the departure to the arrival
constexpr double longest_line_steps = 2.0;                   // of the grid: a line that is flown out and back
constexpr double courses_deg[] = {0.0, 90.0, 180.0, 270.0};  // of that line, against the plane's x axis
constexpr core::Seconds in_time{1.0};                        // of an arrival
constexpr int most_line_halvings = 40;

/// On the film run backwards, whose clock shows -t: nobody is at a vertex before a vehicle that goes there straight.
struct NotBeforeStraight {
  const StraightBound& to_start;
  core::Seconds depart;

  [[nodiscard]] core::Seconds least_time(const graph::Edge& edge, core::Seconds) const {
    return to_start.least_time(edge);
  }
  [[nodiscard]] static core::Seconds remaining(graph::Vertex) { return core::Seconds{0.0}; }
  [[nodiscard]] core::Seconds latest_use(graph::Vertex v) const { return -(depart + to_start.remaining(v)); }
};

class WaitingWaySearch {
 public:
  /// Everything is borrowed.
  WaitingWaySearch(const cost::Sea& sea, const OpenGrid& open, core::Seconds depart,
                   const std::stop_token& stop)
      : sea_{sea},
        open_{open},
        depart_{depart},
        stop_{stop},
        step_m_{open.grid.shortest_step().value} {}

  WaitingWay find(ArrivalSpan within) && {
    const StraightBound to_goal{sea_, open_.grid, open_.graph, open_.grid.goal};
    const graph::Query query{
        .source = open_.grid.start, .goal = {}, .depart = depart_, .latest = within.before};
    earliest_ =
        graph::find_earliest_arrivals(open_.graph, query, GridTravelTime{sea_, open_.grid}, stop_, to_goal);
    count(earliest_);
    core::Seconds fails = within.after;
    core::Seconds arrives = within.before;
    const auto is_near = [&] { return arrives - fails <= near_enough * (arrives - depart_); };
    for (int i = 0; i < halvings_of_a_wait && !is_near() && !stop_.stop_requested(); ++i) {
      const core::Seconds middle = 0.5 * (fails + arrives);
      if (look_for_arrival(middle)) {
        arrives = std::min(middle, found_.arrival);
      } else {
        fails = middle;
      }
    }
    found_.cancelled = stop_.stop_requested();
    return std::move(found_);
  }

 private:
  /// A vertex where the vehicle may stay.
  struct Place {
    graph::Vertex vertex;
    core::Seconds leaves;  // of its span of time, the one that came first
    core::Seconds spare;   // since it could be there; negative or minus infinity: it cannot
  };

  /// Whether there is such a way that arrives by then, which is kept.
  bool look_for_arrival(core::Seconds arrive) {
    std::vector<graph::Vertex> places;
    const graph::SearchTree latest = sweep_back(arrive, places);
    count(latest);
    for (const graph::Vertex place : places) {
      if (stop_.stop_requested()) return false;
      if (keep_if_open(place, latest, arrive)) return true;
    }
    return false;
  }

  bool keep_if_open(graph::Vertex place, const graph::SearchTree& latest, core::Seconds arrive) {
    std::vector<geo::PlanePoint> there;
    for (const graph::Vertex v : graph::path_to(open_.graph, earliest_, place))
      there.push_back(open_.grid.point(v));
    std::vector<graph::Vertex> onward = graph::path_to(open_.graph, latest, place);
    std::ranges::reverse(onward);
    for (const std::vector<geo::PlanePoint>& circles :
         circles_at(place, core::Seconds{-latest.arrival_s(place)})) {
      std::vector<geo::PlanePoint> path = there;
      path.insert(path.end(), circles.begin(), circles.end());
      for (std::size_t i = 1; i < onward.size(); ++i) path.push_back(open_.grid.point(onward[i]));
      const auto arrivals = cost::arrivals_along(sea_, path, depart_);
      if (!arrivals || arrivals->back() > arrive + in_time) continue;
      found_.path = std::move(path);
      found_.arrival = arrivals->back();
      return true;
    }
    return false;
  }

  /// What to fly from a place and back to it, to leave it then: out and back as often as needed, each by another
  /// course.
  [[nodiscard]] std::vector<std::vector<geo::PlanePoint>> circles_at(graph::Vertex place,
                                                                     core::Seconds until) const {
    std::vector<std::vector<geo::PlanePoint>> result;
    const geo::PlanePoint here = open_.grid.point(place);
    const core::Seconds from{earliest_.arrival_s(place)};
    for (const double course_deg : courses_deg) {
      if (stop_.stop_requested()) return {};
      const double course = core::degrees_to_radians(course_deg);
      const auto lines = [&](int times, double length_m) {
        const geo::PlanePoint end{here.x_m + length_m * std::cos(course),
                                  here.y_m + length_m * std::sin(course)};
        std::vector<geo::PlanePoint> points;
        for (int i = 0; i < times; ++i) points.insert(points.end(), {end, here});
        return points;
      };
      if (auto line = line_until(here, lines, from, until)) result.push_back(std::move(*line));
    }
    return result;
  }

  /// As few lines as need not be longer than allowed, all of the length that ends them in time; none where there is no
  /// time left, empty where they are closed.
  template <class Lines>
  std::optional<std::vector<geo::PlanePoint>> line_until(geo::PlanePoint here, const Lines& lines,
                                                         core::Seconds from, core::Seconds until) const {
    const auto back_at = [&](const std::vector<geo::PlanePoint>& points) -> std::optional<core::Seconds> {
      core::Seconds now = from;
      geo::PlanePoint at = here;
      for (const geo::PlanePoint next : points) {
        const auto time = sea_.leg_time(at, next, now);
        if (!time) return std::nullopt;
        now += *time;
        at = next;
      }
      return now;
    };
    if (until - from <= in_time) return std::vector<geo::PlanePoint>{};
    const double longest_m = longest_line_steps * step_m_;
    const auto once = back_at(lines(1, longest_m));
    if (!once) return std::nullopt;
    const int times = static_cast<int>(std::ceil((until - from) / (*once - from)));
    double short_m = 0.0;
    double long_m = 1.5 * longest_m;  // some lines may take less time than the first
    for (int i = 0; i < most_line_halvings; ++i) {
      const double middle_m = 0.5 * (short_m + long_m);
      auto points = lines(times, middle_m);
      const auto back = back_at(points);
      if (!back) return std::nullopt;
      if (*back <= until && until - *back <= in_time) return points;
      (*back <= until ? short_m : long_m) = middle_m;
    }
    return std::nullopt;
  }

  /// Until when each vertex may be left for this arrival, as far as the vehicle can be there by then.
  /// `places`: becomes those where it can stay until then, of each span of time the one where it has most time left,
  /// for the way past it is the shortest; the search ends with the last of the spans
  graph::SearchTree sweep_back(core::Seconds arrive, std::vector<graph::Vertex>& places) const {
    std::stop_source enough;
    const std::stop_callback pass_on{stop_, [&] { enough.request_stop(); }};
    const core::Seconds span = between_places * (arrive - depart_);
    std::vector<Place> found;
    graph::Vertex tail = open_.grid.goal;
    const GridTravelTimeBack back{sea_, open_.grid};
    const auto travel_time = [&](const graph::Edge& edge, core::Seconds film_time, core::Seconds latest) {
      if (edge.tail != tail) {
        tail = edge.tail;
        const Place place{tail, -film_time, -film_time - core::Seconds{earliest_.arrival_s(tail)}};
        const bool is_same_span = !found.empty() && found.back().leaves - place.leaves < span;
        if (!is_same_span && found.size() >= most_places) enough.request_stop();
        if (enough.stop_requested()) return back(edge, film_time, latest);
        const bool is_better = !is_same_span || place.spare > found.back().spare;
        if (is_better && stays(place)) {
          if (is_same_span) {
            found.back() = {place.vertex, found.back().leaves, place.spare};
          } else {
            found.push_back(place);
          }
        }
      }
      return back(edge, film_time, latest);
    };
    const StraightBound to_start{sea_, open_.grid, open_.graph, open_.grid.start};
    const graph::Query query{.source = open_.grid.goal, .goal = {}, .depart = -arrive, .latest = -depart_};
    graph::SearchTree tree = graph::find_earliest_arrivals(
        open_.graph, query, travel_time, enough.get_token(), NotBeforeStraight{to_start, depart_});
    // From the start, where no edge leads to a better place, none may have been looked at.
    const graph::Vertex start = open_.grid.start;
    const core::Seconds leaves{-tree.arrival_s(start)};
    if (const Place place{start, leaves, leaves - depart_}; tree.is_reached(start) && stays(place))
      found.push_back(place);
    std::ranges::stable_sort(found, std::ranges::greater{}, &Place::spare);
    for (const Place& place : found) places.push_back(place.vertex);
    return tree;
  }

  /// Whether the vehicle can be at the place, and stay there until it leaves.
  [[nodiscard]] bool stays(const Place& place) const {
    if (place.spare.count() < 0.0) return false;
    const core::Seconds from = place.leaves - place.spare;
    const geo::PlanePoint point = open_.grid.point(place.vertex);
    return cost::next_closure(sea_, point, from) > place.leaves;
  }

  void count(const graph::SearchTree& tree) {
    found_.counters.edge_evaluations += tree.counters.edge_evaluations;
    found_.counters.expansions += tree.counters.expansions;
  }

  const cost::Sea& sea_;
  const OpenGrid& open_;
  core::Seconds depart_;
  const std::stop_token& stop_;
  double step_m_;
  graph::SearchTree earliest_{0};  // on its way without waits
  WaitingWay found_;
};

}  // namespace

WaitingWay search_way_with_one_wait(const cost::Sea& sea, const OpenGrid& open, core::Seconds depart,
                                    ArrivalSpan within, const std::stop_token& stop) {
  return WaitingWaySearch{sea, open, depart, stop}.find(within);
}

}  // namespace floeplan::planning::search

#include "engine/planning/surfacing_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "engine/graph/label_search.hpp"
#include "engine/planning/loiter.hpp"
#include "engine/planning/surfacing_wait.hpp"
#include "engine/planning/vertex_closures.hpp"

namespace floeplan::planning {
namespace {

using graph::Edge;
using graph::Vertex;

/// Where the vehicle may wait each label takes some hundred microseconds: with no more of them than this a plan without
/// waits, which is looked for too, does not have to wait long.
constexpr std::size_t most_waiting_labels = 20'000;

/// The model of the search over labels.
class SurfacingVoyage {
 public:
  struct State {
    double since_surfacing_s{};
    std::size_t interval{};  // which of the place's times between closures, where the vehicle may wait
  };
  using Label = graph::Label<State>;

  SurfacingVoyage(const Sea& sea, const OpenGrid& open)
      : sea_{sea},
        grid_{open.grid},
        closures_{sea, open.grid},
        may_wait_{sea.longest_wait().count() > 0.0 && sea.has_timed_closures()},
        unchanging_{!sea.currents() || !sea.currents()->end()},
        earliest_at_surface_s_(open.graph.size(), std::numeric_limits<double>::infinity()) {}

  void extend(const Edge& edge, double arrival_s, const State& state, auto&& emit) {
    const geo::PlanePoint tail = grid_.point(edge.tail);
    const geo::PlanePoint head = grid_.point(edge.head);
    if (may_wait_) return extend_with_waits(edge, {arrival_s, state}, emit);
    double& earliest_s = earliest_at_surface_s_[edge.head];
    if (earliest_s <= arrival_s + sea_.least_time(tail, head).count()) return;  // it would be dominated
    const auto leg = sea_.leg(tail, head, core::Seconds{arrival_s}, core::Seconds{state.since_surfacing_s});
    if (!leg) return;
    const double head_arrival_s = arrival_s + leg->time.count();
    if (leg->since_surfacing.count() == 0.0) earliest_s = std::min(earliest_s, head_arrival_s);
    emit(head_arrival_s, State{.since_surfacing_s = leg->since_surfacing.count()}, 0U);
  }

  void wait(Vertex, double, const State&, auto&&) const {}

  [[nodiscard]] bool may_wait() const { return may_wait_; }

  [[nodiscard]] double key(Vertex v, double arrival_s, const State&) const {
    return arrival_s + sea_.least_time(grid_.point(v), grid_.point(grid_.goal)).count();
  }

  /// In currents that change, the later of two vehicles under ice gains on the earlier one; it has been there for
  /// longer only if its last surfacing lies further back, not if the time since then is greater now.
  [[nodiscard]] bool dominates(Vertex v, const Label& a, const Label& b) const {
    if (a.arrival_s > b.arrival_s) return false;
    if (may_wait_) return may_wait_for(v, a, b);
    if (a.state.since_surfacing_s == 0.0) return true;
    if (unchanging_) return a.state.since_surfacing_s <= b.state.since_surfacing_s;
    return a.arrival_s - a.state.since_surfacing_s >= b.arrival_s - b.state.since_surfacing_s;
  }

 private:
  struct Arrival {
    double s{};
    State state;
  };

  /// At once, and after the least wait for each of the head's times between closures.
  void extend_with_waits(const Edge& edge, const Arrival& here, auto&& emit) {
    const geo::PlanePoint tail = grid_.point(edge.tail);
    const geo::PlanePoint head = grid_.point(edge.head);
    const std::vector<TimeSpan>& closed = closures_.at(edge.head);
    const core::Seconds arrive{here.s};
    for_each_opening(sea_, tail, head, closed, arrive, core::Seconds{INFINITY}, [&](const WaitedLeg& leg) {
      const core::Seconds leaves = arrive + leg.wait;
      const auto since =
          since_surfacing_after_wait(sea_, tail, arrive, leaves, core::Seconds{here.state.since_surfacing_s});
      if (!since) return;
      const auto drive = sea_.leg(tail, head, leaves, *since);
      if (!drive) return;
      const core::Seconds there = leaves + drive->time;
      emit(there.count(), State{drive->since_surfacing.count(), interval_of(closed, there)}, 0U);
    });
  }

  /// Whether who comes first can stay until the other one is there, and be no worse off then.
  [[nodiscard]] bool may_wait_for(Vertex v, const Label& first, const Label& other) const {
    if (first.state.interval != other.state.interval) return false;
    const core::Seconds from{first.arrival_s};
    const core::Seconds until{other.arrival_s};
    const geo::PlanePoint place = grid_.point(v);
    if (until - from > sea_.longest_wait() || !current_lets_stay(sea_, place, from, until)) return false;
    const auto since =
        since_surfacing_after_wait(sea_, place, from, until, core::Seconds{first.state.since_surfacing_s});
    return since && since->count() <= other.state.since_surfacing_s;
  }

  const Sea& sea_;
  const RouteGrid& grid_;
  VertexClosures closures_;
  bool may_wait_;
  bool unchanging_;
  std::vector<double>
      earliest_at_surface_s_;  // of the arrivals so far where the vehicle may surface, by vertex
};

using Labels = graph::LabelSearch<SurfacingVoyage::State>;

/// The arrival nearest to the goal, the earliest of equals; null when there is none.
const SurfacingVoyage::Label* nearest_to_goal(const RouteGrid& grid, const Labels& search) {
  const geo::PlanePoint goal = grid.point(grid.goal);
  const SurfacingVoyage::Label* nearest = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const auto& label : search.labels) {
    const geo::PlanePoint point = grid.point(label.vertex);
    const double distance = std::hypot(point.x_m - goal.x_m, point.y_m - goal.y_m);
    if (distance >= least) continue;
    least = distance;
    nearest = &label;
  }
  return nearest;
}

void describe_end(RouteSearch& result, const Sea& sea, const OpenGrid& open, const Labels& search) {
  const auto* nearest = nearest_to_goal(open.grid, search);
  result.nearest = open.grid.point(nearest != nullptr ? nearest->vertex : open.grid.start);
  if (nearest == nullptr) return;
  result.nearest_arrival = core::Seconds{nearest->arrival_s};
  open.graph.for_each_edge(nearest->vertex, [&](const Edge& edge) {
    const geo::PlanePoint head = open.grid.point(edge.head);
    const auto leg = sea.leg(result.nearest, head, result.nearest_arrival,
                             core::Seconds{nearest->state.since_surfacing_s});
    if (leg) return;
    result.closed_at_nearest.push_back(leg.error());
    result.out_of_time = result.out_of_time || (leg.error() == motion::EdgeClosed::outside_data &&
                                                sea.currents_known(head, result.nearest_arrival));
  });
}

}  // namespace

RouteSearch search_with_surfacings(const Sea& sea, const OpenGrid& open, core::Seconds depart,
                                   core::Seconds since_surfacing, const std::stop_token& stop,
                                   const std::function<void(double)>& report_fraction,
                                   std::size_t most_labels) {
  SurfacingVoyage voyage{sea, open};
  const std::size_t affordable = voyage.may_wait() ? std::min(most_labels, most_waiting_labels) : most_labels;
  const auto report = [&](std::int64_t expansions) {
    const auto vertices = static_cast<double>(std::max<std::int64_t>(1, open.vertices));
    report_fraction(std::min(1.0, static_cast<double>(expansions) / vertices));
  };
  const Labels search =
      graph::find_best_labels(open.graph, open.grid.start, open.grid.goal, depart.count(),
                              SurfacingVoyage::State{.since_surfacing_s = since_surfacing.count()}, voyage,
                              most_labels, stop, report);

  RouteSearch result;
  result.statistics.vertices = open.vertices;
  result.statistics.edges = open.edges;
  result.statistics.expansions = search.counters.expansions;
  result.statistics.edge_evaluations = search.counters.edge_evaluations;
  result.cancelled = search.stopped;
  result.cut_short = search.full;
  if (search.goal) {
    for (const auto& label : graph::way_to(search, *search.goal))
      result.path.push_back(open.grid.point(label.vertex));
    result.since_surfacing = core::Seconds{search.labels[*search.goal].state.since_surfacing_s};
  } else if (!result.cancelled) {
    describe_end(result, sea, open, search);
  }
  return result;
}

}  // namespace floeplan::planning

#include "engine/avoidance/evasive_path.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "engine/avoidance/disc_set.hpp"
#include "engine/avoidance/steering.hpp"
#include "engine/graph/time_dependent_astar.hpp"
#include "engine/motion/crabbing.hpp"

namespace floeplan::avoidance {
namespace {

constexpr double finest_m = 10.0;     // smallest grid step: a third of the usual clearance
constexpr double beside_m = 260.0;    // room on each side: a berg of 200 m with the clearance on both sides
constexpr int most_across = 91;       // rows
constexpr int most_along = 90;        // columns
constexpr double path_slack_m = 3.0;  // more than the watch needs, so that a path stays valid
constexpr double horizon_s = 3600.0;

/// The search's grid. Columns run along the line from the vehicle to the goal; both are vertices.
class LocalGrid {
 public:
  LocalGrid(geo::PlanePoint start, geo::PlanePoint goal) : start_{start} {
    const double length_m = distance_m(start, goal);
    const double wish_m = std::max(
        {finest_m, (length_m + 2.0 * beside_m) / (most_along - 1), 2.0 * beside_m / (most_across - 1)});
    between_ = std::max(1, static_cast<int>(std::ceil(length_m / wish_m)));
    spacing_m_ = length_m / between_;
    pad_ = static_cast<int>(beside_m / wish_m);
    const double direction = direction_rad(start, goal);
    along_ = {std::sin(direction), std::cos(direction)};
  }

  [[nodiscard]] int columns() const { return between_ + 2 * pad_ + 1; }
  [[nodiscard]] int rows() const { return 2 * pad_ + 1; }
  [[nodiscard]] double spacing_m() const { return spacing_m_; }
  [[nodiscard]] graph::Vertex start_of(const graph::GridGraph& graph) const {
    return graph.vertex(pad_, pad_);
  }
  [[nodiscard]] graph::Vertex goal_of(const graph::GridGraph& graph) const {
    return graph.vertex(pad_ + between_, pad_);
  }

  [[nodiscard]] geo::PlanePoint place(const graph::GridGraph& graph, graph::Vertex v) const {
    const double ahead_m = spacing_m_ * (graph.column(v) - pad_);
    const double aside_m = spacing_m_ * (graph.row(v) - pad_);
    return {start_.x_m + ahead_m * along_.x_m - aside_m * along_.y_m,
            start_.y_m + ahead_m * along_.y_m + aside_m * along_.x_m};
  }

 private:
  geo::PlanePoint start_;
  geo::PlanePoint along_{};  // unit vector along the line
  int between_{};
  int pad_{};
  double spacing_m_{};
};

/// Times moves at constant speed over the ground among the obstacles' discs, in seconds from now.
class LocalSea {
 public:
  LocalSea(const Going& going, geo::PlanePoint start, std::vector<Obstacle> obstacles, double clearance_m)
      : crabbing_{core::MetresPerSecond{going.through_water_m_s}},
        current_{going.current},
        discs_{over_ground(obstacles, going.current),
               {.from = start,
                .now_s = 0.0,
                .until_s = horizon_s,
                .clearance_m = clearance_m,
                .takes_guesses = true}} {}

  /// Arrival on a straight line; empty: the current is too strong, or an obstacle is in the way.
  [[nodiscard]] std::optional<double> arrival_s(geo::PlanePoint from, geo::PlanePoint to,
                                                double depart_s) const {
    const double length_m = distance_m(from, to);
    const double ex = (to.x_m - from.x_m) / length_m;
    const double ey = (to.y_m - from.y_m) / length_m;
    const auto slowness = crabbing_.slowness({current_.east.value * ex + current_.north.value * ey,
                                              current_.east.value * ey - current_.north.value * ex});
    if (!slowness) return std::nullopt;
    const double arrive_s = depart_s + length_m * *slowness;
    if (discs_.is_touched({from, to, depart_s, arrive_s})) return std::nullopt;
    return arrive_s;
  }

 private:
  static std::span<const Obstacle> over_ground(std::vector<Obstacle>& obstacles, geo::VelocityEn current) {
    for (Obstacle& obstacle : obstacles) {
      obstacle.drift.x_m_s += current.east.value;
      obstacle.drift.y_m_s += current.north.value;
    }
    return obstacles;
  }

  motion::Crabbing crabbing_;
  geo::VelocityEn current_;
  DiscSet discs_;
};

/// Lower bound: a straight line to the goal with the current from astern.
class StraightBound {
 public:
  StraightBound(const graph::GridGraph& graph, const LocalGrid& grid, double fastest_m_s)
      : graph_{graph},
        grid_{grid},
        goal_{grid.place(graph, grid.goal_of(graph))},
        fastest_m_s_{fastest_m_s} {}

  [[nodiscard]] static core::Seconds least_time(const graph::Edge&, core::Seconds) {
    return core::Seconds{0.0};
  }
  [[nodiscard]] core::Seconds remaining(graph::Vertex v) const {
    return core::Seconds{distance_m(grid_.place(graph_, v), goal_) / fastest_m_s_};
  }
  [[nodiscard]] static core::Seconds latest_use(graph::Vertex) {
    return core::Seconds{graph::SearchTree::never};
  }

 private:
  const graph::GridGraph& graph_;
  const LocalGrid& grid_;
  geo::PlanePoint goal_;
  double fastest_m_s_;
};

/// The path with fewer points: each is joined straight to the farthest later point that is then reached no
/// later.
std::vector<TimedPoint> straightened(const std::vector<TimedPoint>& path, const LocalSea& sea) {
  std::vector<TimedPoint> straight{path.front()};
  std::size_t i = 0;
  while (i + 1 < path.size()) {
    std::size_t next = i + 1;
    std::optional<double> arrival;
    for (std::size_t j = path.size() - 1; j > i; --j) {
      arrival = sea.arrival_s(path[i].place, path[j].place, straight.back().time_s);
      if (!arrival) continue;
      next = j;
      break;
    }
    if (!arrival) return path;  // with an earlier departure an edge is closed, so the search's own times stay
    straight.push_back({path[next].place, *arrival});
    i = next;
  }
  return straight;
}

}  // namespace

EvasivePath plan_evasion(const Going& going, geo::PlanePoint goal, const WaterFrame& water,
                         std::span<const Obstacle> obstacles, const AvoidanceSettings& settings,
                         const std::stop_token& stop) {
  EvasivePath result;
  const geo::PlanePoint start = water.from_local(going.place);
  const geo::PlanePoint end = water.from_local(goal);
  if (!(distance_m(start, end) > 1.0)) return result;

  const LocalGrid grid{start, end};
  const graph::GridGraph graph{grid.columns(), grid.rows(), 2};
  const LocalSea sea{
      going, start, {obstacles.begin(), obstacles.end()}, settings.clearance.value + path_slack_m};
  const auto travel_time = [&](const graph::Edge& edge, core::Seconds depart,
                               core::Seconds) -> std::optional<core::Seconds> {
    const auto arrival =
        sea.arrival_s(grid.place(graph, edge.tail), grid.place(graph, edge.head), depart.count());
    if (!arrival) return std::nullopt;
    return core::Seconds{*arrival} - depart;
  };
  std::stop_source budget;
  const std::stop_callback forward{stop, [&] { budget.request_stop(); }};
  // A search checks its stop token before it reports, so the stop is requested one check ahead.
  const auto spend = [&](std::int64_t expansions) {
    if (expansions + 2 * graph::expansions_between_looks > settings.most_expansions) budget.request_stop();
  };
  const double fastest_m_s = going.through_water_m_s + geo::strength(going.current).value;
  const graph::Query query{.source = grid.start_of(graph),
                           .goal = grid.goal_of(graph),
                           .depart = core::Seconds{0.0},
                           .latest = core::Seconds{horizon_s}};
  const graph::SearchTree tree = graph::find_earliest_arrivals(
      graph, query, travel_time, budget.get_token(), StraightBound{graph, grid, fastest_m_s}, spend);
  result.expansions = tree.counters.expansions;
  result.out_of_budget = tree.stopped;
  if (tree.stopped || !tree.is_reached(*query.goal)) return result;

  std::vector<TimedPoint> path;
  for (const graph::Vertex v : graph::path_to(graph, tree, *query.goal)) {
    path.push_back({grid.place(graph, v), tree.arrival_s(v)});
  }
  for (const TimedPoint& point : straightened(path, sea)) {
    // Converts back to the water frame: a place on the ground is met where it has drifted to by then.
    result.way.add({{point.place.x_m - point.time_s * going.current.east.value,
                     point.place.y_m - point.time_s * going.current.north.value},
                    going.time_s + point.time_s});
  }
  return result;
}

}  // namespace floeplan::avoidance

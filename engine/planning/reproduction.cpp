#include "engine/planning/reproduction.hpp"

#include <cmath>
#include <stop_token>

#include "engine/graph/label_setting_search.hpp"
#include "engine/graph/tve_search.hpp"
#include "engine/motion/edge_time.hpp"
#include "engine/planning/analytic_currents.hpp"
#include "engine/planning/river_extremal.hpp"

namespace floeplan::planning {
namespace {

using graph::Edge;
using graph::GridGraph;
using graph::Vertex;

constexpr double converged = 1e-7;
constexpr double product_default = 1e-4;

/// A grid of the paper: extents, steps, start and goal as columns and rows.
struct Case {
  const char* row;
  std::optional<double> paper_s;
  std::optional<double> verified_s;
  geo::PlanePoint low;
  double dx;
  double dy;
  int nx;
  int ny;
  int sectors;
  int start_column;
  int start_row;
  int goal_column;
  int goal_row;
  bool frozen;
  const char* remark;
};

template <motion::PlaneCurrent Current>
struct PlaneTravelTime {
  const Case& grid;
  const GridGraph& graph;
  const Current& current;
  core::MetresPerSecond through_water;
  double tolerance;

  [[nodiscard]] geo::PlanePoint point(Vertex v) const {
    return {grid.low.x_m + grid.dx * graph.column(v), grid.low.y_m + grid.dy * graph.row(v)};
  }
  tl::expected<core::Seconds, motion::EdgeClosed> operator()(const Edge& edge, core::Seconds depart,
                                                             core::Seconds latest) const {
    return leg(point(edge.tail), point(edge.head), depart, latest);
  }
  [[nodiscard]] tl::expected<core::Seconds, motion::EdgeClosed> leg(geo::PlanePoint a, geo::PlanePoint b,
                                                                    core::Seconds depart,
                                                                    core::Seconds latest = core::Seconds{
                                                                        INFINITY}) const {
    const core::Metres length{std::hypot(b.x_m - a.x_m, b.y_m - a.y_m)};
    return motion::edge_time({a, b, length}, depart, through_water, current,
                             {.relative_tolerance = tolerance}, latest);
  }
};

/// Arrival of the search; of the frozen one, the time that its path really takes.
template <motion::PlaneCurrent Current>
std::optional<double> arrival(const Case& grid, const GridGraph& graph, const Current& current,
                              core::MetresPerSecond through_water, double tolerance) {
  const PlaneTravelTime<Current> travel_time{grid, graph, current, through_water, tolerance};
  const Vertex goal = graph.vertex(grid.goal_column, grid.goal_row);
  const graph::Query query{graph.vertex(grid.start_column, grid.start_row), goal, core::Seconds{0.0}};
  if (!grid.frozen) {
    const auto tree = graph::find_earliest_arrivals_tve(graph, query, travel_time, std::stop_token{});
    if (!tree.is_reached(goal)) return std::nullopt;
    return tree.arrival_s(goal);
  }

  const auto at_departure = [&](const Edge& edge, core::Seconds, core::Seconds latest) {
    return travel_time(edge, query.depart, latest);
  };
  const auto tree = graph::find_earliest_arrivals(graph, query, at_departure, std::stop_token{});
  const std::vector<Vertex> path = graph::path_to(graph, tree, goal);
  if (path.empty()) return std::nullopt;
  core::Seconds now = query.depart;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const auto time = travel_time.leg(travel_time.point(path[i - 1]), travel_time.point(path[i]), now);
    if (!time) return std::nullopt;
    now += *time;
  }
  return now.count();
}

template <motion::PlaneCurrent Current>
ReproducedRow reproduce(const Case& grid, const Current& current, core::MetresPerSecond through_water) {
  const GridGraph graph{grid.nx, grid.ny, grid.sectors};
  ReproducedRow row;
  row.row = grid.row;
  row.paper_s = grid.paper_s;
  row.verified_s = grid.verified_s;
  row.remark = grid.remark;
  row.ours_s = arrival(grid, graph, current, through_water, converged);
  row.ours_at_default_tolerance_s = arrival(grid, graph, current, through_water, product_default);
  row.vertices = graph.count_open_vertices();
  row.edges = graph.count_edges();
  return row;
}

template <motion::PlaneCurrent Current>
ReproducedRow direct_drive(geo::PlanePoint from, geo::PlanePoint to, const Current& current,
                           core::MetresPerSecond through_water) {
  const core::Metres length{std::hypot(to.x_m - from.x_m, to.y_m - from.y_m)};
  const auto time = [&](double tolerance) -> std::optional<double> {
    const auto leg = motion::edge_time({from, to, length}, core::Seconds{0.0}, through_water, current,
                                       {.relative_tolerance = tolerance});
    if (!leg) return std::nullopt;
    return leg->count();
  };
  ReproducedRow row;
  row.row = "direct drive";
  row.ours_s = time(converged);
  row.ours_at_default_tolerance_s = time(product_default);
  return row;
}

void fill_percentages(std::vector<ReproducedRow>& rows, std::optional<double> direct_s, double optimum_s) {
  for (ReproducedRow& row : rows) {
    if (!row.ours_s) continue;
    if (direct_s) row.saving_pct = 100.0 * (*direct_s - *row.ours_s) / *direct_s;
    row.deviation_pct = 100.0 * (*row.ours_s - optimum_s) / optimum_s;
  }
}

}  // namespace

std::vector<ReproducedRow> reproduce_table_2() {
  constexpr core::MetresPerSecond through_water{2.2};
  const RiverCurrent river;
  // Steps in metres, then columns, rows, sectors; start (0, 30), goal (300, 30).
  const std::vector<Case> cases{
      {"large", 165.48, 165.484, {}, 10, 5, 31, 13, 1, 0, 6, 30, 6, false, ""},
      {"medium", 165.48, 165.484, {}, 5, 2.5, 61, 25, 1, 0, 12, 60, 12, false, ""},
      {"small", 165.47, 165.468, {}, 2, 1, 151, 61, 1, 0, 30, 150, 30, false, ""},
      {"2:1", 165.48, 165.484, {}, 10, 5, 31, 13, 1, 0, 6, 30, 6, false, ""},
      {"1:1", 176.33, 176.334, {}, 5, 5, 61, 13, 1, 0, 6, 60, 6, false, ""},
      {"1:2", 179.52, 179.517, {}, 5, 10, 61, 7, 1, 0, 3, 60, 3, false, "equals direct drive"},
      {"1-sector", 165.48, 165.484, {}, 10, 5, 31, 13, 1, 0, 6, 30, 6, false, ""},
      {"2-sector", 162.79, 162.790, {}, 10, 5, 31, 13, 2, 0, 6, 30, 6, false, ""},
      {"3-sector",
       162.73,
       162.362,
       {},
       10,
       5,
       31,
       13,
       3,
       0,
       6,
       30,
       6,
       false,
       "misprint: the paper's own 9.56 % and 0.35 % give 162.36"},
      {"frozen 1-sector",
       {},
       {},
       {},
       10,
       5,
       31,
       13,
       1,
       0,
       6,
       30,
       6,
       true,
       "the river is steady: same as TVE"},
      {"frozen 2-sector",
       {},
       {},
       {},
       10,
       5,
       31,
       13,
       2,
       0,
       6,
       30,
       6,
       true,
       "the river is steady: same as TVE"},
      {"frozen 3-sector",
       {},
       {},
       {},
       10,
       5,
       31,
       13,
       3,
       0,
       6,
       30,
       6,
       true,
       "the river is steady: same as TVE"},
  };

  std::vector<ReproducedRow> rows;
  rows.push_back(direct_drive({0.0, 30.0}, {300.0, 30.0}, river, through_water));
  rows.back().paper_s = 167.52;
  rows.back().verified_s = 179.517;
  rows.back().remark = "misprint: the paper's own 10.96 % gives 179.52";
  const double optimum_s = river_crossing_by_optimal_control(river, through_water).count();
  ReproducedRow optimum;
  optimum.row = "optimal control";
  optimum.paper_s = 161.79;
  optimum.verified_s = 161.792;
  optimum.ours_s = optimum_s;
  rows.push_back(optimum);
  for (const Case& grid : cases) rows.push_back(reproduce(grid, river, through_water));
  fill_percentages(rows, rows.front().ours_s, optimum_s);
  return rows;
}

std::vector<ReproducedRow> reproduce_table_3() {
  constexpr core::MetresPerSecond through_water{0.5};
  constexpr double optimum = 17.159;  // of the stand-in, by collocation
  const MeanderingJet jet;
  const auto grid = [](const char* row, std::optional<double> paper, std::optional<double> verified,
                       int sectors, bool frozen, const char* remark) {
    return Case{row, paper, verified, {-10.0, -5.0}, 0.5, 0.5, 41, 21, sectors, 4, 6, 40, 12, frozen, remark};
  };
  const std::vector<Case> cases{
      grid("1-sector", 19.623, 19.606, 1, false, ""),
      grid("2-sector", 17.951, 18.006, 2, false, ""),
      grid("3-sector", 17.719, 17.730, 3, false, ""),
      grid("4-sector", {}, 17.730, 4, false, "no gain, as the paper says"),
      grid("5-sector", {}, 17.730, 5, false, "no gain, as the paper says"),
      grid("frozen 1-sector", {}, {}, 1, true, "weights at departure, then timed honestly"),
      grid("frozen 2-sector", {}, {}, 2, true, "weights at departure, then timed honestly"),
      grid("frozen 3-sector", {}, {}, 3, true, "weights at departure, then timed honestly"),
  };

  std::vector<ReproducedRow> rows;
  rows.push_back(direct_drive({-8.0, -2.0}, {10.0, 1.0}, jet, through_water));
  rows.back().remark = "not possible, as the paper says";
  for (const Case& each : cases) rows.push_back(reproduce(each, jet, through_water));
  fill_percentages(rows, std::nullopt, optimum);
  return rows;
}

}  // namespace floeplan::planning

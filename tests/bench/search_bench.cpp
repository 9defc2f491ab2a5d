#include <algorithm>
#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <utility>

#include "engine/graph/time_dependent_astar.hpp"
#include "tests/bench/benchmarks.hpp"
#include "tests/bench/midpoint_star.hpp"

namespace floeplan::bench {
namespace {

using graph::Edge;
using graph::GridGraph;
using graph::Vertex;

constexpr int sectors = 3;

/// The cost in the form of the search: the edges of a vertex are requested one after the other, and computed
/// together.
class MidpointTravelTime {
 public:
  MidpointTravelTime(const Water& water, const MidpointEdges& edges, const GridGraph& graph)
      : water_{water}, edges_{edges}, graph_{graph} {}

  std::optional<core::Seconds> operator()(const Edge& edge, core::Seconds depart, core::Seconds) const {
    if (edge.tail != tail_) {
      tail_ = edge.tail;
      star_times(water_, edges_, graph_.column(tail_), graph_.row(tail_), static_cast<float>(depart.count()),
                 times_);
    }
    const float time_s = times_.time_s[edge.step];
    if (time_s == MidpointEdges::never) return std::nullopt;
    return core::Seconds{static_cast<double>(time_s)};
  }

 private:
  const Water& water_;
  const MidpointEdges& edges_;
  const GridGraph& graph_;
  mutable Vertex tail_{std::numeric_limits<Vertex>::max()};
  mutable StarTimes times_{};
};

struct Searched {
  double seconds{};
  double bytes_per_vertex{};
  std::vector<double> arrivals_s;
};

Vertex centre_of(int side) { return static_cast<Vertex>(side / 2 * side + side / 2); }

Searched search(const Water& water, int side, int tries) {
  Searched result;
  reset_peak();
  std::unique_ptr<graph::SearchTree> tree;
  result.seconds = least_seconds(tries, [&] {
    tree.reset();
    const GridGraph graph{side, side, sectors};
    const MidpointEdges edges{water, graph.offsets()};
    tree = std::make_unique<graph::SearchTree>(
        graph::find_earliest_arrivals(graph, graph::Query{centre_of(side), std::nullopt, core::Seconds{0.0}},
                                      MidpointTravelTime{water, edges, graph}, std::stop_token{}));
  });
  const auto vertices = static_cast<std::size_t>(side) * static_cast<std::size_t>(side);
  result.bytes_per_vertex = static_cast<double>(peak_bytes()) / static_cast<double>(vertices);
  for (Vertex v = 0; v < vertices; ++v) result.arrivals_s.push_back(tree->arrival_s(v));
  return result;
}

using BoostGraph =
    boost::compressed_sparse_row_graph<boost::directedS, boost::no_property, boost::no_property,
                                       boost::no_property, std::uint32_t, std::uint32_t>;
using BoostEdge = boost::graph_traits<BoostGraph>::edge_descriptor;

/// The same cost as a property map of the Boost library, which requests a weight when the edge's tail has its
/// final distance. It requests each edge twice; the second answer is cached, to the library's advantage.
struct MidpointWeight {
  using key_type = BoostEdge;
  using value_type = double;
  using reference = double;
  using category = boost::readable_property_map_tag;

  const Water* water;
  const MidpointEdges* edges;
  const BoostGraph* graph;
  const std::vector<std::uint8_t>* steps;  // by edge index
  const std::vector<double>* distances;
  int side;
  std::pair<std::uint32_t, double>* latest;

  friend double get(const MidpointWeight& map, const BoostEdge& edge) {
    if (edge.idx == map.latest->first) return map.latest->second;
    const auto tail = static_cast<int>(edge.src);
    const float time = midpoint_time(*map.water, *map.edges, tail % map.side, tail / map.side,
                                     (*map.steps)[edge.idx], static_cast<float>((*map.distances)[edge.src]));
    *map.latest = {edge.idx, static_cast<double>(time)};
    return static_cast<double>(time);
  }
};

struct BoostSearched {
  double build_s{};
  Searched searched;
};

BoostSearched search_with_boost(const Water& water, int side) {
  BoostSearched result;
  reset_peak();
  const double start = thread_seconds();
  const GridGraph grid{side, side, sectors};
  const MidpointEdges edges{water, grid.offsets()};
  std::vector<std::uint8_t> steps;
  std::unique_ptr<BoostGraph> graph;
  {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> ends;
    ends.reserve(static_cast<std::size_t>(grid.count_edges()));
    steps.reserve(ends.capacity());
    for (Vertex v = 0; v < grid.size(); ++v) {
      grid.for_each_edge(v, [&](const Edge& edge) {
        ends.emplace_back(edge.tail, edge.head);
        steps.push_back(edge.step);
      });
    }
    graph = std::make_unique<BoostGraph>(boost::edges_are_sorted, ends.begin(), ends.end(),
                                         static_cast<std::uint32_t>(grid.size()));
  }
  result.build_s = thread_seconds() - start;

  std::vector<double> distances(grid.size());
  std::vector<std::uint32_t> predecessors(grid.size());
  std::pair<std::uint32_t, double> latest{std::numeric_limits<std::uint32_t>::max(), 0.0};
  const MidpointWeight weight{&water, &edges, graph.get(), &steps, &distances, side, &latest};
  const auto index = get(boost::vertex_index, *graph);
  boost::dijkstra_shortest_paths(
      *graph, centre_of(side),
      boost::weight_map(weight)
          .distance_map(boost::make_iterator_property_map(distances.begin(), index))
          .predecessor_map(boost::make_iterator_property_map(predecessors.begin(), index))
          .distance_inf(std::numeric_limits<double>::infinity()));
  result.searched.seconds = thread_seconds() - start;
  result.searched.bytes_per_vertex =
      static_cast<double>(peak_bytes()) / (static_cast<double>(side) * static_cast<double>(side));
  result.searched.arrivals_s = std::move(distances);
  return result;
}

/// Throws if the arrivals differ by more than rounding; vector and scalar operations round differently.
void refuse_other_arrivals(const std::vector<double>& ours, const std::vector<double>& theirs) {
  for (std::size_t v = 0; v < ours.size(); ++v) {
    if (ours[v] == theirs[v]) continue;
    if (!(std::abs(ours[v] - theirs[v]) <= 1e-5 * theirs[v] + 1.0)) {
      throw std::runtime_error{"the two searches disagree at vertex " + std::to_string(v)};
    }
  }
}

std::vector<Row> edge_rows(const Water& water, int side) {
  const GridGraph graph{side, side, sectors};
  const MidpointEdges edges{water, graph.offsets()};
  const auto evaluations = static_cast<double>(graph.size()) * static_cast<double>(graph.offsets().size());
  volatile double sink = 0.0;
  const auto time_of_all = [&](const auto& time_vertex) {
    return least_seconds(3, [&] {
      double sum = 0.0;
      for (int row = 0; row < side; ++row) {
        for (int column = 0; column < side; ++column) {
          sum += time_vertex(column, row, 1'000.0F * static_cast<float>(row));
        }
      }
      sink = sum;
    });
  };
  StarTimes times{};
  const double together_s = time_of_all([&](int column, int row, float depart_s) {
    star_times(water, edges, column, row, depart_s, times);
    return static_cast<double>(times.time_s[static_cast<std::size_t>(column) % MidpointEdges::most]);
  });
  const double singly_s = time_of_all([&](int column, int row, float depart_s) {
    double sum = 0.0;
    for (std::size_t step = 0; step < graph.offsets().size(); ++step) {
      const auto near_column = std::clamp(column, 3, side - 4);  // its edges stay inside the grid
      const auto near_row = std::clamp(row, 3, side - 4);
      sum += static_cast<double>(midpoint_time(water, edges, near_column, near_row, step, depart_s));
    }
    return sum;
  });
  Row row =
      more_is_better("edge evaluations, midpoint-corrected, one core", "million/s",
                     1e-6 * evaluations / together_s, "one edge at a time", 1e-6 * evaluations / singly_s);
  row.target = ">= 100 million/s";
  row.meets_target = row.ours >= 100.0;
  row.gauge = Gauge::rate;
  return {row};
}

std::vector<Row> growth_rows() {
  std::vector<Row> rows;
  double least = std::numeric_limits<double>::infinity();
  double most = 0.0;
  for (const int side : {100, 316, 1'000, 3'162}) {
    const Water water{side};
    const Searched searched = search(water, side, side < 1'000 ? 5 : 1);
    const double n = static_cast<double>(side) * side;
    const double share_ns = 1e9 * searched.seconds / (n * std::log2(n));
    least = std::min(least, share_ns);
    most = std::max(most, share_ns);
    rows.push_back({.what = "time / (n log2 n) at n = " + std::to_string(side * side) + " vertices",
                    .unit = "ns",
                    .ours = share_ns,
                    .comparator = {}});
  }
  rows.push_back({.what = "largest of these over the smallest",
                  .unit = "ratio",
                  .ours = most / least,
                  .comparator = {}});
  return rows;
}

}  // namespace

std::vector<Row> search_rows() {
  constexpr int side = 1'000;
  const Water water{side};
  std::vector<Row> rows = edge_rows(water, side);

  const Searched ours = search(water, side, 3);
  const BoostSearched boost = search_with_boost(water, side);
  refuse_other_arrivals(ours.arrivals_s, boost.searched.arrivals_s);

  const auto edges = static_cast<double>(GridGraph{side, side, sectors}.count_edges());
  rows.push_back({.what = "directed edges searched, 1000 x 1000, 3-sector, 300 slices",
                  .unit = "million/s",
                  .ours = 1e-6 * edges / ours.seconds,
                  .comparator = "Boost, build + search",
                  .comparator_value = 1e-6 * edges / boost.searched.seconds,
                  .ratio = boost.searched.seconds / ours.seconds});
  rows.push_back(less_is_better("the same, our build + search beside a search alone", "ms",
                                1e3 * ours.seconds, "Boost Dijkstra on CSR, search alone",
                                1e3 * (boost.searched.seconds - boost.build_s)));
  Row total = less_is_better("the same, build + search", "ms", 1e3 * ours.seconds,
                             "Boost Dijkstra on CSR, build + search", 1e3 * boost.searched.seconds);
  total.target = ">= 5 times as fast";
  total.meets_target = total.ratio >= 5.0;
  total.gauge = Gauge::comparator;
  rows.push_back(total);
  Row memory = less_is_better("memory beside the field", "bytes/vertex", ours.bytes_per_vertex,
                              "Boost Dijkstra on CSR", boost.searched.bytes_per_vertex);
  memory.target = "<= 24 bytes";
  memory.meets_target = memory.ours <= 24.0;
  memory.gauge = Gauge::comparator;
  rows.push_back(memory);

  for (Row& row : growth_rows()) rows.push_back(std::move(row));
  return rows;
}

}  // namespace floeplan::bench

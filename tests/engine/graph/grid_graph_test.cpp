#include "engine/graph/grid_graph.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <numeric>
#include <stdexcept>

#include "tests/support/property.hpp"

namespace floeplan::graph::grid_graph_test {
namespace {

TEST(SectorOffsets, AreEightSixteenAndThirtyTwo) {
  EXPECT_EQ(sector_offsets(1).size(), 8U);
  EXPECT_EQ(sector_offsets(2).size(), 16U);
  EXPECT_EQ(sector_offsets(3).size(), 32U);
}

TEST(SectorOffsets, StartInTheEastAndTurnCounterClockwise) {
  const std::vector<Offset> expected{{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}};

  EXPECT_EQ(sector_offsets(1), expected);
}

TEST(SectorOffsets, NeverPassOverAVertexThatAShorterOneReaches) {
  for (int sectors = 1; sectors <= 5; ++sectors) {
    for (const Offset o : sector_offsets(sectors)) EXPECT_EQ(std::gcd(o.dx, o.dy), 1);
  }
}

TEST(SectorOffsets, AreRefusedOutsideOneToFiveSectors) {
  EXPECT_THROW((void)sector_offsets(0), std::invalid_argument);
  EXPECT_THROW((void)sector_offsets(6), std::invalid_argument);
}

struct Size {
  int nx;
  int ny;
  int sectors;
  std::int64_t vertices;
  std::int64_t edges;
};

class OpenGrid : public testing::TestWithParam<Size> {};

TEST_P(OpenGrid, HasTheVerticesAndEdgesOfTheTable) {
  const Size size = GetParam();
  const GridGraph graph{size.nx, size.ny, size.sectors};

  EXPECT_EQ(graph.count_open_vertices(), size.vertices);
  EXPECT_EQ(graph.count_edges(), size.edges);
}

INSTANTIATE_TEST_SUITE_P(Table, OpenGrid,
                         testing::Values(Size{31, 13, 1, 403, 2964}, Size{31, 13, 2, 403, 5676},
                                         Size{31, 13, 3, 403, 10612}, Size{61, 25, 1, 1525, 11688},
                                         Size{151, 61, 1, 9211, 72420}, Size{61, 13, 1, 793, 5904},
                                         Size{61, 7, 1, 427, 3012}, Size{41, 21, 1, 861, 6520},
                                         Size{41, 21, 2, 861, 12680}, Size{41, 21, 3, 861, 24296}));

TEST(GridGraph, WithClosedVerticesCountsWhatEveryPairOfVerticesCounts) {
  support::for_each_seed(60, [](std::mt19937_64& rng) {
    const int nx = support::uniform_int(rng, 1, 9);
    const int ny = support::uniform_int(rng, 1, 9);
    const int sectors = support::uniform_int(rng, 1, 3);
    std::vector<std::uint8_t> open(static_cast<std::size_t>(nx * ny));
    for (auto& flag : open) flag = static_cast<std::uint8_t>(support::uniform_int(rng, 0, 3) > 0);
    const GridGraph graph{nx, ny, sectors, open};

    std::int64_t pairs = 0;
    for (Vertex a = 0; a < graph.size(); ++a) {
      for (Vertex b = 0; b < graph.size(); ++b) {
        const int dx = graph.column(b) - graph.column(a);
        const int dy = graph.row(b) - graph.row(a);
        const bool joined = std::abs(dx) <= sectors && std::abs(dy) <= sectors && std::gcd(dx, dy) == 1;
        if (joined && open[a] != 0 && open[b] != 0) ++pairs;
      }
    }

    EXPECT_EQ(graph.count_edges(), pairs);
    EXPECT_EQ(graph.count_open_vertices(), std::accumulate(open.begin(), open.end(), std::int64_t{0}));
  });
}

TEST(GridGraph, FindsTheTailOfEachEdgeFromItsHead) {
  const GridGraph graph{9, 8, 3};
  for (Vertex tail = 0; tail < graph.size(); ++tail) {
    graph.for_each_edge(tail, [&](const Edge& edge) {
      EXPECT_EQ(edge.tail, tail);
      EXPECT_EQ(graph.tail_of(edge.head, edge.step), tail);
    });
  }
}

TEST(GridGraph, RefusesAnEmptyGridAndAWrongNumberOfFlags) {
  EXPECT_THROW((GridGraph{0, 5, 1}), std::invalid_argument);
  EXPECT_THROW((GridGraph{100'000, 100'000, 1}), std::invalid_argument);
  EXPECT_THROW((GridGraph{2, 2, 1, {1, 1, 1}}), std::invalid_argument);
}

}  // namespace
}  // namespace floeplan::graph::grid_graph_test

#pragma once

#include <array>
#include <limits>
#include <vector>

#include "engine/graph/grid_graph.hpp"
#include "tests/bench/water.hpp"

namespace floeplan::bench {

/// The simplest accurate travel time of an edge: the speed at the tail gives the time at the middle, and the
/// speed there gives the time of the whole edge.
struct MidpointEdges {
  static constexpr std::size_t most = 32;  // edges out of a vertex of a 3-sector grid
  static constexpr float spacing_m = 1'000.0F;
  static constexpr float through_water_m_s = 0.35F;
  static constexpr float never = std::numeric_limits<float>::infinity();

  alignas(64) std::array<float, most> length_m{};
  alignas(64) std::array<float, most> ex{};
  alignas(64) std::array<float, most> ey{};
  alignas(64) std::array<float, most> half_x{};  // from the tail to the middle, in cells of the water
  alignas(64) std::array<float, most> half_y{};

  MidpointEdges(const Water& water, const std::vector<graph::Offset>& offsets);
};

/// Travel times in seconds, by step; `never` if the edge is closed. Values of edges that leave the grid are
/// undefined.
struct alignas(64) StarTimes {
  std::array<float, MidpointEdges::most> time_s;
};

/// Computes all edges out of a vertex at once, with the vector instructions of the processor. The order of
/// operations is fixed, so all processors give the same bits.
void star_times(const Water& water, const MidpointEdges& edges, int column, int row, float depart_s,
                StarTimes& times);

/// The same for one edge, for a library that requests weights edge by edge.
float midpoint_time(const Water& water, const MidpointEdges& edges, int column, int row, std::size_t step,
                    float depart_s);

}  // namespace floeplan::bench

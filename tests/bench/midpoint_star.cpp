#include "tests/bench/midpoint_star.hpp"

#include <algorithm>
#include <cmath>

namespace floeplan::bench {
namespace {

constexpr std::size_t most = MidpointEdges::most;
constexpr float v2 = MidpointEdges::through_water_m_s * MidpointEdges::through_water_m_s;
constexpr float v_min = 0.01F * MidpointEdges::through_water_m_s;

struct Lookup {
  int cell;
  float share;
};

Lookup locate(float at, int cells) {
  const int cell = std::clamp(static_cast<int>(at), 0, cells - 1);
  return {cell, at - static_cast<float>(cell)};
}

Water::Node current_at(const Water& water, float x, float y, float t_s) {
  const Lookup column = locate(x, Water::nodes - 1);
  const Lookup row = locate(y, Water::nodes - 1);
  const Lookup slice = locate(t_s / Water::slice_s, Water::slices - 1);
  const auto in_slice = [&](int s) {
    const Water::Node* south = &water.at(s, row.cell, column.cell);
    const Water::Node* north = south + Water::nodes;
    const auto mix = [&](float sw, float se, float nw, float ne) {
      const float a = sw + column.share * (se - sw);
      const float b = nw + column.share * (ne - nw);
      return a + row.share * (b - a);
    };
    return Water::Node{mix(south[0].x_m_s, south[1].x_m_s, north[0].x_m_s, north[1].x_m_s),
                       mix(south[0].y_m_s, south[1].y_m_s, north[0].y_m_s, north[1].y_m_s)};
  };
  const Water::Node before = in_slice(slice.cell);
  const Water::Node after = in_slice(slice.cell + 1);
  return {before.x_m_s + slice.share * (after.x_m_s - before.x_m_s),
          before.y_m_s + slice.share * (after.y_m_s - before.y_m_s)};
}

/// Speed over ground along the edge; zero if the vehicle makes no progress. Written without a branch, for
/// vectorisation.
inline float speed(float x_m_s, float y_m_s, float ex, float ey) {
  const float along = x_m_s * ex + y_m_s * ey;
  const float across = x_m_s * ey - y_m_s * ex;
  const float margin = v2 - across * across;
  const float v = along + std::sqrt(margin > 0.0F ? margin : 0.0F);
  return static_cast<float>((margin > 0.0F) & (v > v_min)) * v;
}

}  // namespace

MidpointEdges::MidpointEdges(const Water& water, const std::vector<graph::Offset>& offsets) {
  for (std::size_t step = 0; step < offsets.size() && step < most; ++step) {
    const auto dx = static_cast<float>(offsets[step].dx);
    const auto dy = static_cast<float>(offsets[step].dy);
    const float steps = std::sqrt(dx * dx + dy * dy);
    length_m[step] = spacing_m * steps;
    ex[step] = dx / steps;
    ey[step] = dy / steps;
    half_x[step] = 0.5F * dx * water.cells_per_vertex;
    half_y[step] = 0.5F * dy * water.cells_per_vertex;
  }
}

float midpoint_time(const Water& water, const MidpointEdges& edges, int column, int row, std::size_t step,
                    float depart_s) {
  const float x = static_cast<float>(column) * water.cells_per_vertex;
  const float y = static_cast<float>(row) * water.cells_per_vertex;
  const Water::Node tail = current_at(water, x, y, depart_s);
  const float v0 = speed(tail.x_m_s, tail.y_m_s, edges.ex[step], edges.ey[step]);
  if (!(v0 > 0.0F)) return MidpointEdges::never;
  const Water::Node middle = current_at(water, x + edges.half_x[step], y + edges.half_y[step],
                                        depart_s + 0.5F * edges.length_m[step] / v0);
  const float v = speed(middle.x_m_s, middle.y_m_s, edges.ex[step], edges.ey[step]);
  return v > 0.0F ? edges.length_m[step] / v : MidpointEdges::never;
}

// A bilinear value is the sum of the values at the nodes, each weighted by its closeness. The nine nodes
// around the tail cover all middles, so the edges need no lookups of their own: all lanes use the same nodes
// with different weights.
__attribute__((target_clones("default", "avx2", "avx512f"))) void star_times(
    const Water& water, const MidpointEdges& edges, int column, int row, float depart_s, StarTimes& times) {
  const float x = static_cast<float>(column) * water.cells_per_vertex;
  const float y = static_cast<float>(row) * water.cells_per_vertex;
  const int middle_column = std::clamp(static_cast<int>(x + 0.5F), 1, Water::nodes - 2);
  const int middle_row = std::clamp(static_cast<int>(y + 0.5F), 1, Water::nodes - 2);
  const Water::Node tail = current_at(water, x, y, depart_s);

  alignas(64) float slice_at[most];
  alignas(64) float v0[most];
  for (std::size_t i = 0; i < most; ++i) {
    v0[i] = speed(tail.x_m_s, tail.y_m_s, edges.ex[i], edges.ey[i]);
    const float half_s = 0.5F * edges.length_m[i] / (v0[i] > v_min ? v0[i] : v_min);
    slice_at[i] = (depart_s + half_s) * (1.0F / Water::slice_s);
  }
  float latest[most / 2];
  for (std::size_t i = 0; i < most / 2; ++i) {
    latest[i] = slice_at[i] > slice_at[i + most / 2] ? slice_at[i] : slice_at[i + most / 2];
  }
  for (std::size_t half = most / 4; half > 0; half /= 2) {
    for (std::size_t i = 0; i < half; ++i)
      latest[i] = latest[i] > latest[i + half] ? latest[i] : latest[i + half];
  }

  alignas(64) float weight_x[3][most];
  alignas(64) float weight_y[3][most];
  alignas(64) float current_x[most] = {};
  alignas(64) float current_y[most] = {};
  for (int k = 0; k < 3; ++k) {
    const float from_x = x - static_cast<float>(middle_column - 1 + k);
    const float from_y = y - static_cast<float>(middle_row - 1 + k);
    for (std::size_t i = 0; i < most; ++i) {
      const float near_x = 1.0F - std::abs(from_x + edges.half_x[i]);
      const float near_y = 1.0F - std::abs(from_y + edges.half_y[i]);
      weight_x[k][i] = near_x > 0.0F ? near_x : 0.0F;
      weight_y[k][i] = near_y > 0.0F ? near_y : 0.0F;
    }
  }

  const int first = std::clamp(static_cast<int>(depart_s / Water::slice_s), 0, Water::slices - 2);
  const int last = std::clamp(static_cast<int>(latest[0]) + 1, first + 1, Water::slices - 1);
  for (int slice = first; slice <= last; ++slice) {
    const Water::Node* south = &water.at(slice, middle_row - 1, middle_column - 1);
    const Water::Node* centre = south + Water::nodes;
    const Water::Node* north = centre + Water::nodes;
    const auto slice_f = static_cast<float>(slice);
    for (std::size_t i = 0; i < most; ++i) {
      const float wx0 = weight_x[0][i];
      const float wx1 = weight_x[1][i];
      const float wx2 = weight_x[2][i];
      const float near = 1.0F - std::abs(slice_at[i] - slice_f);
      const float weight = near > 0.0F ? near : 0.0F;
      const float sx =
          weight_y[0][i] * (wx0 * south[0].x_m_s + wx1 * south[1].x_m_s + wx2 * south[2].x_m_s) +
          weight_y[1][i] * (wx0 * centre[0].x_m_s + wx1 * centre[1].x_m_s + wx2 * centre[2].x_m_s) +
          weight_y[2][i] * (wx0 * north[0].x_m_s + wx1 * north[1].x_m_s + wx2 * north[2].x_m_s);
      const float sy =
          weight_y[0][i] * (wx0 * south[0].y_m_s + wx1 * south[1].y_m_s + wx2 * south[2].y_m_s) +
          weight_y[1][i] * (wx0 * centre[0].y_m_s + wx1 * centre[1].y_m_s + wx2 * centre[2].y_m_s) +
          weight_y[2][i] * (wx0 * north[0].y_m_s + wx1 * north[1].y_m_s + wx2 * north[2].y_m_s);
      current_x[i] += weight * sx;
      current_y[i] += weight * sy;
    }
  }
  for (std::size_t i = 0; i < most; ++i) {
    const float v = speed(current_x[i], current_y[i], edges.ex[i], edges.ey[i]);
    const float slowest = v < v0[i] ? v : v0[i];
    const float time = edges.length_m[i] / v;
    times.time_s[i] = slowest > 0.0F ? time : MidpointEdges::never;
  }
}

}  // namespace floeplan::bench

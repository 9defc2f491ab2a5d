#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <random>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/graph/grid_graph.hpp"
#include "tests/support/property.hpp"

namespace floeplan::graph {

/// Travel times that oscillate about the mean of each edge, slowly enough that FIFO holds: |dw/dt| < 1. One
/// edge in ten is never passable.
class SwingingTimes {
 public:
  SwingingTimes(const GridGraph& graph, std::mt19937_64& rng)
      : graph_{graph}, waves_(graph.size() * graph.offsets().size()) {
    for (Wave& wave : waves_) {
      wave.mean_s = support::uniform(rng, least_pace_s / (1.0 - largest_swing), 200.0);
      wave.swing = support::uniform(rng, 0.0, largest_swing);
      // The steepest slope is mean * swing * length * rate; the longest step is sqrt(13) < 4 cells.
      wave.rate_per_s = support::uniform(rng, 0.0, 0.95) / (wave.mean_s * largest_swing * 4.0);
      wave.phase = support::uniform(rng, 0.0, 6.28);
      wave.open = support::uniform_int(rng, 0, 9) > 0;
    }
  }

  std::optional<core::Seconds> operator()(const Edge& edge, core::Seconds depart, core::Seconds) const {
    const Wave& wave = waves_[edge.tail * graph_.offsets().size() + edge.step];
    if (!wave.open) return std::nullopt;
    const double factor = 1.0 + wave.swing * std::sin(wave.rate_per_s * depart.count() + wave.phase);
    return core::Seconds{wave.mean_s * factor * cells(graph_.offsets()[edge.step])};
  }

  /// The least time of an edge, at any departure, per cell of its length.
  static constexpr double least_pace_s = 30.0;
  static double cells(Offset o) { return std::hypot(o.dx, o.dy); }

 private:
  static constexpr double largest_swing = 0.6;
  struct Wave {
    double mean_s{};
    double swing{};
    double rate_per_s{};
    double phase{};
    bool open{};
  };
  const GridGraph& graph_;
  std::vector<Wave> waves_;
};

/// A random grid of at most 12 x 12 vertices, one in five of them closed; the first one is open.
inline GridGraph random_grid(std::mt19937_64& rng) {
  const int nx = support::uniform_int(rng, 2, 12);
  const int ny = support::uniform_int(rng, 2, 12);
  std::vector<std::uint8_t> open(static_cast<std::size_t>(nx * ny));
  for (auto& flag : open) flag = static_cast<std::uint8_t>(support::uniform_int(rng, 0, 4) > 0);
  open.front() = 1;
  return GridGraph{nx, ny, support::uniform_int(rng, 1, 3), open};
}

}  // namespace floeplan::graph

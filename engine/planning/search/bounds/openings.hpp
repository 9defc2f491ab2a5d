#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <stop_token>
#include <vector>

#include "engine/planning/cost/sea.hpp"
#include "engine/planning/search/bounds/arrival_ladder.hpp"
#include "engine/planning/search/grid/open_grid.hpp"

namespace floeplan::planning::search {

/// Where and when a later arrival can be better, because something that is closed near the vertex opens again:
/// only there a search must keep more than the earliest arrival. A disc that only grows never opens anything.
/// Reach    six steps of the grid, two of its longest edges, about each vertex, and as long before the closure as
///          the vehicle needs to go there and back
/// Threads  const members may be called from several threads at once
class Openings {
 public:
  /// None.
  Openings() = default;
  /// `latest`: what opens after it is of no use. `closures`: of the grid, so
  /// far as they are worked out. `ladder`: where given, neither is what opens near a vertex after that
  /// is of use. Stops early once `stop` is requested; then not to be used.
  Openings(const cost::Sea& sea, const OpenGrid& grid, core::Seconds latest, const std::stop_token& stop,
           VertexClosures* closures = nullptr, const ArrivalLadder* ladder = nullptr);

  [[nodiscard]] bool matter(graph::Vertex v, double arrival_s) const {
    return matter(v, arrival_s, arrival_s);
  }
  /// For some arrival between the two.
  [[nodiscard]] bool matter(graph::Vertex v, double first_s, double last_s) const {
    return !windows_.empty() && windows_[v].from_s <= last_s && first_s <= windows_[v].until_s;
  }

 private:
  struct Window {
    double from_s{std::numeric_limits<double>::infinity()};
    double until_s{-std::numeric_limits<double>::infinity()};

    void include(const Window& other) {
      from_s = std::min(from_s, other.from_s);
      until_s = std::max(until_s, other.until_s);
    }
  };
  void widen(int nx, int ny);

  std::vector<Window> windows_;  // of each vertex; none at all when nothing opens
};

}  // namespace floeplan::planning::search

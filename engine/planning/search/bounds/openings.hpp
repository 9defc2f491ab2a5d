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

/// Where and when a later arrival can be better than an earlier one, because a place nearby reopens. Only
/// there must a search keep more than the earliest arrival at a vertex. A disc that only grows never reopens
/// a place.
/// Reach    six steps of the grid, or two of its longest edges, around each vertex. In time, a window begins
///          before the closure, by the time that the vehicle needs to go there and back
/// Threads  const members may be called from several threads at once
class Openings {
 public:
  /// Without windows: nothing reopens.
  Openings() = default;
  /// `latest`: reopenings after it do not matter. `closures`: of the grid, as far as they have been computed.
  /// `ladder`: if given, reopenings after the latest useful time of a vertex do not matter either. Stops early once
  /// `stop` is requested; the object must then not be used.
  Openings(const cost::Sea& sea, const OpenGrid& grid, core::Seconds latest, const std::stop_token& stop,
           VertexClosures* closures = nullptr, const ArrivalLadder* ladder = nullptr);

  [[nodiscard]] bool matter(graph::Vertex v, double arrival_s) const {
    return matter(v, arrival_s, arrival_s);
  }
  /// Whether some arrival at the vertex between the two times may be worse than a later one. Times in
  /// seconds.
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

  std::vector<Window> windows_;  // of each vertex; empty if nothing reopens
};

}  // namespace floeplan::planning::search

#pragma once

#include <unordered_map>
#include <vector>

#include "engine/planning/open_grid.hpp"
#include "engine/planning/sea.hpp"

namespace floeplan::planning {

/// When the vertices of a grid are closed for a while, by timed zones or icebergs that move; worked out when it is
/// first asked.
/// Threads  one at a time
class VertexClosures {
 public:
  /// Both are borrowed and outlive this.
  VertexClosures(const Sea& sea, const RouteGrid& grid) : sea_{sea}, grid_{grid} {}

  /// Ascending, apart from each other. Borrowed from this.
  [[nodiscard]] const std::vector<TimeSpan>& at(graph::Vertex v) {
    if (!sea_.has_timed_closures()) return never_;
    const auto [closed, is_new] = closed_.try_emplace(v);
    if (is_new) closed->second = sea_.closed_times(grid_.point(v));
    return closed->second;
  }

 private:
  const Sea& sea_;
  const RouteGrid& grid_;
  std::unordered_map<graph::Vertex, std::vector<TimeSpan>> closed_;  // of those asked for
  std::vector<TimeSpan> never_;
};

}  // namespace floeplan::planning

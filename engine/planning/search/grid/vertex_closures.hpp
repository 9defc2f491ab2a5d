#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "engine/planning/obstacles/closures.hpp"
#include "engine/planning/search/grid/open_grid.hpp"

namespace floeplan::planning::search {

/// The times when vertices of a grid are closed by timed zones or moving icebergs. They are computed when
/// they are first asked for.
/// Threads  one at a time
class VertexClosures {
 public:
  /// `closures` is a view of a leg cost model, which must outlive this object; `grid` is borrowed, too.
  VertexClosures(const obstacles::Closures& closures, const cost::RouteGrid& grid)
      : closures_{closures}, grid_{grid}, kept_(closures.any_timed() ? count(grid) : 0, not_asked) {}

  /// Closed times of the vertex, ascending and disjoint. Borrowed from this object.
  [[nodiscard]] const std::vector<TimeSpan>& at(graph::Vertex v) {
    if (kept_.empty()) return spans_.front();
    if (kept_[v] == not_asked) {
      std::vector<TimeSpan> closed = closures_.closed_times(grid_.point(v));
      kept_[v] = closed.empty() ? never_closed : static_cast<std::uint32_t>(spans_.size());
      if (!closed.empty()) spans_.push_back(std::move(closed));
    }
    return spans_[kept_[v]];
  }

 private:
  static constexpr std::uint32_t never_closed = 0;
  static constexpr std::uint32_t not_asked = UINT32_MAX;
  [[nodiscard]] static std::size_t count(const cost::RouteGrid& grid) {
    return static_cast<std::size_t>(grid.nx) * static_cast<std::size_t>(grid.ny);
  }

  obstacles::Closures closures_;
  const cost::RouteGrid& grid_;
  std::vector<std::uint32_t> kept_;  // of each vertex: index into `spans_`; empty: nothing ever closes
  std::deque<std::vector<TimeSpan>> spans_{
      std::vector<TimeSpan>{}};  // closed times of vertices; the first, empty, is for all that never close
};

}  // namespace floeplan::planning::search

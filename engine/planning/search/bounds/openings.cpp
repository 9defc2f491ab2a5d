#include "engine/planning/search/bounds/openings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace floeplan::planning::search {
namespace {

constexpr int reach = 6;  // in steps of the grid
constexpr graph::Vertex openings_check_interval = 256;

}  // namespace

Openings::Openings(const cost::Sea& sea, const OpenGrid& grid, core::Seconds latest,
                   const std::stop_token& stop, VertexClosures* closures, const ArrivalLadder* ladder) {
  const double step_m = std::max(std::hypot(grid.grid.along.x_m, grid.grid.along.y_m),
                                 std::hypot(grid.grid.across.x_m, grid.grid.across.y_m));
  const double before_s = 2.0 * reach * (core::Metres{step_m} / sea.through_water()).count();
  bool any = false;
  std::vector<Window> windows(grid.graph.size());
  for (graph::Vertex v = 0; v < windows.size(); ++v) {
    if (v % openings_check_interval == 0 && stop.stop_requested()) return;
    if (!grid.graph.is_open(v)) continue;
    const core::Seconds of_use{ladder != nullptr ? ladder->latest_use_s(v)
                                                 : std::numeric_limits<double>::infinity()};
    if (of_use.count() == -std::numeric_limits<double>::infinity()) continue;
    const std::vector<TimeSpan> spans =
        closures != nullptr ? closures->at(v) : sea.domain().closures().closed_times(grid.grid.point(v));
    for (const TimeSpan& closed : spans) {
      if (closed.until > std::min(latest, of_use) || !std::isfinite(closed.until.count())) continue;
      any = true;
      windows[v].include({closed.from.count() - before_s, closed.until.count()});
    }
  }
  if (!any) return;
  windows_ = std::move(windows);
  widen(grid.grid.nx, grid.grid.ny);
}

/// Gives every vertex the windows of all vertices within `reach`, first along the rows, then along the
/// columns.
void Openings::widen(int nx, int ny) {
  const auto spread = [&](int count, int lines, std::size_t step, std::size_t line_step) {
    std::vector<Window> line(static_cast<std::size_t>(count));
    for (int l = 0; l < lines; ++l) {
      const std::size_t first = static_cast<std::size_t>(l) * line_step;
      for (int i = 0; i < count; ++i)
        line[static_cast<std::size_t>(i)] = windows_[first + static_cast<std::size_t>(i) * step];
      for (int i = 0; i < count; ++i) {
        Window& here = windows_[first + static_cast<std::size_t>(i) * step];
        for (int j = std::max(0, i - reach); j <= std::min(count - 1, i + reach); ++j) {
          here.include(line[static_cast<std::size_t>(j)]);
        }
      }
    }
  };
  const auto row = static_cast<std::size_t>(nx);
  spread(nx, ny, 1, row);
  spread(ny, nx, row, 1);
}

}  // namespace floeplan::planning::search

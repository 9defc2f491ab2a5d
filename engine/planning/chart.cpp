#include "engine/planning/chart.hpp"

#include <optional>
#include <utility>

#include "engine/planning/explanation.hpp"

namespace floeplan::planning {
namespace {

constexpr double most_vertices = 2.5e7;  // about 1 GB with the queue and the maps

/// Why a stop cannot be used; opens the map around each one that can.
std::optional<Infeasible> check_stops(Sea& sea, const Layout& layout, const PlanRequest& request) {
  for (std::size_t i = 0; i < layout.stops.size(); ++i) {
    const Stop kind = i == 0 ? Stop::start : i + 1 == layout.stops.size() ? Stop::goal : Stop::via;
    if (const auto closed = sea.safety().closed_at(layout.stops[i]))
      return explain_place(*closed, kind, layout.stops[i], request);
    if (sea.icebergs().contains(layout.points[i])) {
      return explain_place(motion::EdgeClosed::obstacle, kind, layout.stops[i], request);
    }
    constexpr TimeSpan at_departure{core::Seconds{0.0}, core::Seconds{0.0}};
    if (kind == Stop::start && sea.timed_zones().forbid(layout.points[i], layout.points[i], at_departure)) {
      return explain_place(motion::EdgeClosed::in_zone, kind, layout.stops[i], request);
    }
    sea.safety().open_around(layout.points[i]);
  }
  return std::nullopt;
}

}  // namespace

Result<Chart> draw_chart(const ocean::Environment& environment, const PlanRequest& request, GridReach reach,
                         const std::stop_token& stop) {
  Layout layout = lay_out(request, reach);
  if (request.method != Method::direct && layout.most_vertices() > most_vertices) {
    return tl::unexpected(explain_too_large(layout.most_vertices(), request));
  }
  const core::Metres cell = layout.map_cell();
  const PlaneBox area = layout.bounds().grown(2.0 * cell.value);
  Sea sea{environment, request, layout.projection, area, cell, stop};
  if (stop.stop_requested()) return tl::unexpected(explain_cancelled(request));
  if (auto unusable = check_stops(sea, layout, request)) return tl::unexpected(std::move(*unusable));
  return Chart{.layout = std::move(layout), .sea = std::move(sea)};
}

}  // namespace floeplan::planning

#include "engine/planning/chart.hpp"

#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "engine/planning/explanation.hpp"
#include "engine/planning/usable_place.hpp"

namespace floeplan::planning {
namespace {

constexpr double most_vertices = 2.5e7;        // about 1 GB with the queue and the maps
constexpr std::size_t most_icebergs = 20'000;  // some seconds of forecasts, 100 MB of them and their index

Stop kind_of(std::size_t stop, const Layout& layout) {
  if (stop == 0) return Stop::start;
  return stop + 1 == layout.stops.size() ? Stop::goal : Stop::via;
}

/// An iceberg keeps the vehicle from a start that it covers at the departure, from the others if it covers them for
/// ever.
bool is_kept_by_iceberg(const Sea& sea, geo::PlanePoint stop, bool is_start) {
  const std::vector<TimeSpan> closed = sea.icebergs().closed_times(stop);
  if (closed.empty() || closed.front().from > core::Seconds{0.0}) return false;
  return is_start || !std::isfinite(closed.front().until.count());
}

std::optional<motion::EdgeClosed> closed_stop(const Sea& sea, const Layout& layout, std::size_t stop) {
  if (const auto closed = sea.safety().closed_at(layout.stops[stop])) return closed;
  const geo::PlanePoint point = layout.points[stop];
  if (is_kept_by_iceberg(sea, point, stop == 0)) return motion::EdgeClosed::obstacle;
  constexpr TimeSpan at_departure{core::Seconds{0.0}, core::Seconds{0.0}};
  if (stop == 0 && sea.timed_zones().forbid(point, point, at_departure)) return motion::EdgeClosed::in_zone;
  return std::nullopt;
}

/// The stop moved to where the vehicle may be: to the nearest place from which it comes to another stop, or the nearest of
/// all.
std::vector<Change> moves_of(const Sea& sea, const Layout& layout, std::size_t stop,
                             const std::stop_token& token) {
  const geo::PlanePoint other = stop == 0 ? layout.points.back() : layout.points.front();
  const Stop kind = kind_of(stop, layout);
  const std::string input = kind == Stop::start  ? "from"
                            : kind == Stop::goal ? "to"
                                                 : "via/" + std::to_string(stop - 1);
  std::vector<Change> moves;
  for (const auto& place : {nearest_usable_place_towards(sea, layout.points[stop], other, token),
                            nearest_usable_place(sea, layout.points[stop])}) {
    if (!place || (!moves.empty() && std::get<geo::LonLat>(moves.front().to) == *place)) continue;
    moves.push_back(move_of(input, layout.stops[stop], *place));
  }
  return moves;
}

/// Why a stop cannot be used; opens the map around each one that can.
std::optional<Infeasible> check_stops(Sea& sea, const Layout& layout, const PlanRequest& request,
                                      const std::stop_token& token, Moves moves) {
  for (std::size_t stop = 0; stop < layout.stops.size(); ++stop) {
    if (const auto closed = closed_stop(sea, layout, stop)) {
      Infeasible infeasible = explain_place(*closed, kind_of(stop, layout), layout.stops[stop], sea, request);
      if (moves == Moves::looked_for) infeasible.moves = moves_of(sea, layout, stop, token);
      return infeasible;
    }
    sea.safety().open_around(layout.points[stop]);
  }
  return std::nullopt;
}

}  // namespace

std::optional<Infeasible> too_much_to_lay_out(const ocean::Environment& environment,
                                              const PlanRequest& request) {
  if (environment.icebergs.size() <= most_icebergs) return std::nullopt;
  return explain_too_many_icebergs(environment.icebergs.size(), request);
}

Result<Chart> chart_on(Sea sea, Layout layout, const PlanRequest& request, const std::stop_token& stop,
                       Moves moves) {
  if (request.method == Method::direct) sea.safety().open_along(layout.points, layout.projection);
  if (auto unusable = check_stops(sea, layout, request, stop, moves))
    return tl::unexpected(std::move(*unusable));
  return Chart{.layout = std::move(layout), .sea = std::move(sea)};
}

Result<Chart> draw_chart(const ocean::Environment& environment, const PlanRequest& request, GridReach reach,
                         const std::stop_token& stop, CurrentsShelf* shelf, Moves moves) {
  if (auto too_much = too_much_to_lay_out(environment, request)) return tl::unexpected(std::move(*too_much));
  Layout layout = lay_out(request, reach);
  if (request.method != Method::direct && layout.most_vertices() > most_vertices) {
    return tl::unexpected(explain_too_large(layout.most_vertices(), request));
  }
  Sea sea{environment, request, layout.projection, layout.area(), layout.map_cell(), stop, shelf};
  if (stop.stop_requested()) return tl::unexpected(explain_cancelled(request));
  return chart_on(std::move(sea), std::move(layout), request, stop, moves);
}

}  // namespace floeplan::planning

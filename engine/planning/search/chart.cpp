#include "engine/planning/search/chart.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "engine/planning/search/explanation.hpp"
#include "engine/planning/search/usable_place.hpp"

namespace floeplan::planning::search {
namespace {

constexpr double most_vertices = 2.5e7;        // about 1 GB with the queue and the maps
constexpr std::size_t most_icebergs = 20'000;  // some seconds of forecasts; 100 MB with their index

Stop kind_of(std::size_t stop, const cost::Layout& layout) {
  if (stop == 0) return Stop::start;
  return stop + 1 == layout.stops.size() ? Stop::goal : Stop::via;
}

/// Whether an iceberg covers the place from the departure on, for ever.
bool is_kept_for_ever(const cost::Sea& sea, geo::PlanePoint place) {
  const std::vector<TimeSpan> closed = sea.domain().icebergs().closed_times(place);
  return !closed.empty() && closed.front().from <= core::Seconds{0.0} &&
         !std::isfinite(closed.front().until.count());
}

std::optional<motion::EdgeClosed> closed_stop(const cost::Sea& sea, const cost::Layout& layout,
                                              std::size_t stop) {
  if (const auto closed = sea.domain().safety().closed_at(layout.stops[stop])) return closed;
  if (is_kept_for_ever(sea, layout.points[stop])) return motion::EdgeClosed::obstacle;
  return std::nullopt;
}

/// The reason why the vehicle cannot be at the place at that time.
std::optional<motion::EdgeClosed> closed_then(const cost::Sea& sea, geo::PlanePoint place,
                                              core::Seconds when) {
  const auto covers = [&](const TimeSpan& span) { return span.from <= when && when <= span.until; };
  if (std::ranges::any_of(sea.domain().icebergs().closed_times(place), covers))
    return motion::EdgeClosed::obstacle;
  if (sea.domain().closures().timed_zones().forbid(place, place, {when, when}))
    return motion::EdgeClosed::in_zone;
  return std::nullopt;
}

/// Suggestions to move an unusable stop: to the nearest usable place with a connection to another stop or, if
/// there is none, to the nearest usable place, `nearest`.
std::vector<Change> moves_of(const cost::Sea& sea, const cost::Layout& layout, std::size_t stop,
                             const std::optional<geo::LonLat>& nearest, const std::stop_token& token) {
  const geo::PlanePoint other = stop == 0 ? layout.points.back() : layout.points.front();
  const Stop kind = kind_of(stop, layout);
  const std::string input = kind == Stop::start  ? "from"
                            : kind == Stop::goal ? "to"
                                                 : "via/" + std::to_string(stop - 1);
  std::vector<Change> moves;
  for (const auto& place :
       {nearest_usable_place_towards(sea.domain(), layout.points[stop], other, token), nearest}) {
    if (!place || (!moves.empty() && std::get<geo::LonLat>(moves.front().to) == *place)) continue;
    moves.push_back(move_of(input, layout.stops[stop], *place));
  }
  return moves;
}

/// The reason why a stop cannot be used; empty if all can. Opens the safety map around each usable stop.
std::optional<Infeasible> check_stops(cost::Sea& sea, const ocean::Environment& environment,
                                      const cost::Layout& layout, const PlanRequest& request,
                                      const std::stop_token& token, Moves moves) {
  for (std::size_t stop = 0; stop < layout.stops.size(); ++stop) {
    if (const auto closed = closed_stop(sea, layout, stop)) {
      Infeasible infeasible =
          explain_place(*closed, kind_of(stop, layout), layout.stops[stop], sea, environment, request);
      if (moves == Moves::looked_for) {
        const auto nearest = nearest_usable_place(sea.domain(), layout.points[stop]);
        infeasible.moves = moves_of(sea, layout, stop, nearest, token);
        if (closed == motion::EdgeClosed::on_land || closed == motion::EdgeClosed::too_shallow)
          infeasible.besides.push_back(
              tell_of_nearest_water(kind_of(stop, layout), layout.stops[stop], nearest));
      }
      return infeasible;
    }
    sea.domain().safety().open_around(layout.points[stop]);
  }
  return std::nullopt;
}

}  // namespace

std::optional<Infeasible> too_much_to_lay_out(const ocean::Environment& environment,
                                              const PlanRequest& request) {
  if (environment.icebergs.size() <= most_icebergs) return std::nullopt;
  return explain_too_many_icebergs(environment.icebergs.size(), request);
}

Result<Chart> chart_on(cost::Sea sea, const ocean::Environment& environment, cost::Layout layout,
                       const PlanRequest& request, const std::stop_token& stop, Moves moves) {
  if (request.method == Method::direct) sea.domain().safety().open_along({layout.points}, layout.projection);
  if (auto unusable = check_stops(sea, environment, layout, request, stop, moves))
    return tl::unexpected(std::move(*unusable));
  Chart chart{.layout = std::move(layout), .sea = std::move(sea)};
  const bool leaves_at_once = !request.departures.until && !request.departures.arrive_by;
  if (leaves_at_once) {
    if (auto closed = closed_start(chart, request, core::Seconds{0.0})) {
      if (moves == Moves::looked_for)
        closed->moves = moves_of(chart.sea, chart.layout, 0,
                                 nearest_usable_place(chart.sea.domain(), chart.layout.points.front()), stop);
      return tl::unexpected(std::move(*closed));
    }
  }
  return chart;
}

std::optional<Infeasible> closed_start(const Chart& chart, const PlanRequest& request, core::Seconds after) {
  const auto closed = closed_then(chart.sea, chart.layout.points.front(), after);
  if (!closed) return std::nullopt;
  return explain_start(*closed, chart.layout.stops.front(), after, chart.sea, request);
}

Result<Chart> draw_chart(const ocean::Environment& environment, const PlanRequest& request,
                         cost::GridReach reach, const std::stop_token& stop, cost::SeaShelf* shelf,
                         Moves moves) {
  if (auto too_much = too_much_to_lay_out(environment, request)) return tl::unexpected(std::move(*too_much));
  cost::Layout layout = cost::lay_out(request, reach);
  if (request.method != Method::direct && layout.most_vertices() > most_vertices) {
    return tl::unexpected(explain_too_large(layout.most_vertices(), request));
  }
  cost::Sea sea{environment, request, layout.projection, layout.area(), layout.map_cell(), stop, shelf};
  if (stop.stop_requested()) return tl::unexpected(explain_cancelled(request));
  return chart_on(std::move(sea), environment, std::move(layout), request, stop, moves);
}

}  // namespace floeplan::planning::search

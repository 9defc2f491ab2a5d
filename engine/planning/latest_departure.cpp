#include "engine/planning/latest_departure.hpp"

#include <algorithm>
#include <cmath>
#include <ranges>
#include <stdexcept>
#include <utility>

#include "engine/core/utc_text.hpp"
#include "engine/graph/label_setting_search.hpp"
#include "engine/planning/chart.hpp"
#include "engine/planning/explanation.hpp"
#include "engine/planning/grid_travel.hpp"
#include "engine/planning/plan_route.hpp"
#include "engine/planning/what_would_help.hpp"

namespace floeplan::planning {
namespace {

constexpr core::Seconds close_enough{60.0};
constexpr double close_enough_share = 1e-3;  // of the travel time
constexpr int most_plans = 8;

/// A first departure to try, by the legs of the grids; the earliest one when they know of none.
Result<core::UtcTime> first_guess(const ocean::Environment& environment, const PlanRequest& request,
                                  const std::stop_token& stop) {
  constexpr core::Seconds earliest{0.0};
  const core::Seconds arrive = *request.departures.arrive_by - request.depart;
  for (const GridReach reach : {first_reach, second_reach}) {
    const auto chart = draw_chart(environment, request, reach, stop);
    if (!chart) return tl::unexpected(chart.error());
    if (request.method == Method::direct) break;
    const auto grids = open_grids(chart->sea, chart->layout.grids, request.sectors, stop);
    const auto depart = latest_departure(chart->sea, grids, arrive, earliest, stop);
    if (stop.stop_requested()) return tl::unexpected(explain_cancelled(request));
    if (depart) return request.depart + *depart;
  }
  return request.depart;
}

core::UtcTime whole_second(core::UtcTime time) {
  return core::from_unix_seconds(std::floor(core::unix_seconds(time)));
}

Infeasible too_early(const PlanRequest& request, const Plan& earliest) {
  const core::UtcTime wanted = *request.departures.arrive_by;
  const core::UtcTime possible = core::from_unix_seconds(std::ceil(core::unix_seconds(earliest.arrival)));
  const std::string possible_text = core::iso8601(possible);
  return {
      Reason::arrival_too_early,
      request.to,
      wanted,
      "leaving at " + core::iso8601(request.depart) + ", the earliest departure, arrives at " + possible_text,
      "arrive by then or later, allow an earlier departure (--depart), or raise the speed",
      Constraint::caller,
      {{"arrive_by", wanted, possible, "arrive by " + possible_text}}};
}

core::UtcTime between(core::UtcTime early, core::UtcTime late) {
  return whole_second(early + 0.5 * (late - early));
}

Result<Plan> try_to_arrive(const ocean::Environment& environment, const PlanRequest& request,
                           const std::stop_token& stop, const core::ProgressCallback& progress,
                           const core::SteadyClock& clock) {
  const core::UtcTime wanted = request.departures.arrive_by.value();
  const auto guess = first_guess(environment, request, stop);
  if (!guess) return tl::unexpected(guess.error());

  // What is left of the time is added to the departure as long as the arrival stays in time, what is missing
  // taken from it: under FIFO both come to rest at the latest departure.
  core::UtcTime depart = std::max(whole_second(*guess), request.depart);
  std::optional<Plan> best;
  std::optional<core::UtcTime> too_late;  // a departure that would miss the arrival
  for (int tries = 0; tries < most_plans; ++tries) {
    auto plan = try_to_plan(environment, leaving_at(request, depart), stop, progress, clock);
    if (!plan) {
      if (best && plan.error().reason != Reason::cancelled) break;
      return plan;
    }
    const core::Seconds left = wanted - plan->arrival;
    if (left.count() >= 0.0) {
      const core::Seconds tolerance = std::max(close_enough, close_enough_share * plan->travel_time());
      best = std::move(*plan);
      if (left <= tolerance) break;
      depart = too_late ? between(best->departure, *too_late) : whole_second(depart + left);
      continue;
    }
    too_late = depart;
    if (best) {
      depart = between(best->departure, *too_late);
      if (depart - best->departure < close_enough) break;
      continue;
    }
    if (depart <= request.depart) return tl::unexpected(too_early(request, *plan));
    depart = std::max(whole_second(depart + left - close_enough), request.depart);
  }
  if (best) return std::move(*best);

  auto earliest = try_to_plan(environment, leaving_at(request, request.depart), stop, progress, clock);
  if (!earliest || earliest->arrival <= wanted) return earliest;
  return tl::unexpected(too_early(request, *earliest));
}

}  // namespace

std::optional<core::Seconds> latest_departure(const Sea& sea, const OpenGrid& open, core::Seconds arrive,
                                              core::Seconds earliest, const std::stop_token& stop) {
  const GridTravelTimeBack travel_time{sea, open.grid};
  const StraightBound bound{sea, open.grid, open.graph, open.grid.start};
  const graph::Query query{
      .source = open.grid.goal, .goal = open.grid.start, .depart = -arrive, .latest = -earliest};
  const graph::SearchTree tree = graph::find_earliest_arrivals(open.graph, query, travel_time, stop, bound);
  if (tree.stopped || !tree.is_reached(open.grid.start)) return std::nullopt;
  return core::Seconds{-tree.arrival_s(open.grid.start)};
}

std::optional<core::Seconds> latest_departure(const Sea& sea, const std::vector<OpenGrid>& grids,
                                              core::Seconds arrive, core::Seconds earliest,
                                              const std::stop_token& stop) {
  for (const OpenGrid& open : std::views::reverse(grids)) {
    const auto depart = latest_departure(sea, open, arrive, earliest, stop);
    if (!depart) return std::nullopt;
    arrive = *depart;
  }
  if (arrive < earliest) return std::nullopt;
  return arrive;
}

Result<Plan> plan_arrival(const ocean::Environment& environment, const PlanRequest& request,
                          const std::stop_token& stop, const core::ProgressCallback& progress,
                          const core::SteadyClock& clock) {
  throw_if_invalid(request);
  Result<Plan> plan = try_to_arrive(environment, request, stop, progress, clock);
  if (plan) return plan;
  return tl::unexpected(with_what_would_help(environment, request, std::move(plan.error()), stop, progress));
}

}  // namespace floeplan::planning

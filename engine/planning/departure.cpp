#include "engine/planning/departure.hpp"

#include <functional>
#include <stdexcept>
#include <utility>

#include "engine/planning/chart.hpp"
#include "engine/planning/explanation.hpp"
#include "engine/planning/open_grid.hpp"
#include "engine/planning/plan_route.hpp"
#include "engine/planning/route_cost.hpp"
#include "engine/planning/voyage_search.hpp"

namespace floeplan::planning {
namespace {

/// Searches the same grids for one departure after another.
class DepartureSweep {
 public:
  /// Errors   as draw_chart
  static Result<DepartureSweep> on_grids(GridReach reach, const ocean::Environment& environment,
                                         const PlanRequest& request, const std::stop_token& stop) {
    auto chart = draw_chart(environment, request, reach, stop);
    if (!chart) return tl::unexpected(chart.error());
    std::vector<OpenGrid> grids;
    if (request.method != Method::direct) {
      grids = open_grids(chart->sea, chart->layout.grids, request.sectors, stop);
    }
    return DepartureSweep{std::move(*chart), std::move(grids), request};
  }

  Result<FoundWay> leave(core::Seconds after, const std::stop_token& stop) {
    if (request_.method == Method::direct) return straight(after);
    auto found =
        search_voyage(chart_.sea, grids_, request_, after, stop, [](double) {}, last_ ? &*last_ : nullptr);
    if (found) last_ = *found;
    return found;
  }

 private:
  DepartureSweep(Chart chart, std::vector<OpenGrid> grids, const PlanRequest& request)
      : chart_{std::move(chart)}, grids_{std::move(grids)}, request_{request} {}

  Result<FoundWay> straight(core::Seconds after) const {
    const auto arrivals = arrivals_along(chart_.sea, chart_.layout.points, after);
    if (!arrivals) return tl::unexpected(explain_route(arrivals.error(), chart_.sea, request_));
    FoundWay way;
    way.arrival = arrivals->back();
    return way;
  }

  Chart chart_;
  std::vector<OpenGrid> grids_;
  const PlanRequest& request_;    // borrowed
  std::optional<FoundWay> last_;  // of the departure before
};

/// As a plan for this departure alone would choose between the two reaches.
class Comparison {
 public:
  Comparison(const ocean::Environment& environment, const PlanRequest& request, const std::stop_token& stop)
      : environment_{environment}, request_{request}, stop_{stop} {}

  Result<FoundWay> leave(core::Seconds after) {
    auto first = on(near_, first_reach, after);
    const bool wider_may_help = first ? first->touches_rim : first.error().reason != Reason::cancelled;
    if (!wider_may_help || request_.method == Method::direct) return first;
    auto second = on(wide_, second_reach, after);
    if (first && (!second || first->arrival <= second->arrival)) return first;
    return second;
  }

 private:
  Result<FoundWay> on(std::optional<Result<DepartureSweep>>& sweep, GridReach reach, core::Seconds after) {
    if (!sweep) sweep.emplace(DepartureSweep::on_grids(reach, environment_, request_, stop_));
    if (!*sweep) return tl::unexpected(sweep->error());
    return (*sweep)->leave(after, stop_);
  }

  const ocean::Environment& environment_;
  const PlanRequest& request_;
  const std::stop_token& stop_;
  std::optional<Result<DepartureSweep>> near_;
  std::optional<Result<DepartureSweep>> wide_;  // laid out when it is first needed
};

}  // namespace

Result<std::vector<DepartureOutcome>> compare_departures(const ocean::Environment& environment,
                                                         const PlanRequest& request,
                                                         const std::stop_token& stop,
                                                         const core::ProgressCallback& progress) {
  if (!request.violations().empty()) throw std::invalid_argument{request.violations().front().rule};
  const std::vector<core::UtcTime> departures = request.departures.departures(request.depart);
  Comparison comparison{environment, request, stop};
  std::vector<DepartureOutcome> outcomes;
  for (const core::UtcTime departure : departures) {
    if (progress) {
      progress("departures", static_cast<double>(outcomes.size()) / static_cast<double>(departures.size()));
    }
    auto found = comparison.leave(departure - request.depart);
    DepartureOutcome outcome{
        .departure = departure, .travel_time = std::nullopt, .energy = std::nullopt, .closed = std::nullopt};
    if (found) {
      outcome.travel_time = found->arrival - (departure - request.depart);
    } else if (found.error().reason == Reason::cancelled) {
      return tl::unexpected(std::move(found.error()));
    } else {
      outcome.closed = std::move(found.error());
    }
    outcomes.push_back(std::move(outcome));
  }
  return outcomes;
}

WindowPlan plan_window(const ocean::Environment& environment, const PlanRequest& request,
                       const std::stop_token& stop, const core::ProgressCallback& progress,
                       const core::SteadyClock& clock) {
  auto outcomes = compare_departures(environment, request, stop, progress);
  if (!outcomes) return {.departures = {}, .plan = tl::unexpected(outcomes.error())};
  const auto best = best_departure(*outcomes);
  if (!best) {
    const Infeasible reason = outcomes->front().closed.value();
    return {.departures = std::move(*outcomes), .plan = tl::unexpected(reason)};
  }
  PlanRequest chosen = request;
  chosen.depart = (*outcomes)[*best].departure;
  chosen.departures = {};
  auto plan = plan_route(environment, chosen, stop, progress, clock);
  return {.departures = std::move(*outcomes), .plan = std::move(plan)};
}

std::optional<std::size_t> best_departure(const std::vector<DepartureOutcome>& outcomes) {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    if (!outcomes[i].travel_time) continue;
    if (!best || *outcomes[i].travel_time < *outcomes[*best].travel_time) best = i;
  }
  return best;
}

}  // namespace floeplan::planning

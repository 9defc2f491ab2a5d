#include "engine/planning/planner/departure.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <map>
#include <utility>

#include "engine/messages/plan_messages.hpp"
#include "engine/messages/refusal_messages.hpp"
#include "engine/planning/cost/sea_members.hpp"
#include "engine/planning/planner/departure_search.hpp"
#include "engine/planning/planner/robust_plan.hpp"
#include "engine/planning/planner/strategies.hpp"
#include "engine/planning/search/explanation.hpp"

namespace floeplan::planning::planner {
namespace {

/// Work of making the grids, and of a whole plan with its refinement, for the progress. Unit: the search for
/// one departure. Measured with the demonstration data: a search takes 0.06 s, the others 0.6 s and 0.9 s.
constexpr double searches_a_layout = 10.0;
constexpr double searches_a_plan = 15.0;

/// Limits on departures that are planned in full without success: first the best ones, up to `best_refused`;
/// then those furthest in time from all refused ones, up to `most_refused` in all.
constexpr std::size_t best_refused = 12;
constexpr std::size_t most_refused = 24;

/// Number of departures that are planned in full with a robust objective. Each is planned in every member.
constexpr std::size_t most_planned = 6;

/// The open departure with the longest distance to a closed one; empty: all are closed.
std::optional<std::size_t> furthest_from_refused(const std::vector<DepartureOutcome>& outcomes) {
  const std::size_t count = outcomes.size();
  std::vector<std::size_t> away(count, count);  // number of departures to the nearest closed one
  for (std::size_t i = 0; i < count; ++i) {
    if (!outcomes[i].travel_time) away[i] = 0;
    if (i > 0) away[i] = std::min(away[i], away[i - 1] + 1);
  }
  for (std::size_t i = count - 1; i-- > 0;) away[i] = std::min(away[i], away[i + 1] + 1);
  const auto furthest = std::ranges::max_element(away);
  if (*furthest == 0) return std::nullopt;
  return static_cast<std::size_t>(furthest - away.begin());
}

bool is_robust(const ocean::Environment& environment, const PlanRequest& request) {
  return request.uncertainty.objective != RobustObjective::none &&
         cost::has_uncertain_currents(environment, request);
}

/// Number of environments in which each departure is searched: one, and with a robust objective one more for
/// each member.
std::size_t count_of_seas(const ocean::Environment& environment, const PlanRequest& request) {
  return is_robust(environment, request) ? 1 + cost::SeaMembers{environment, request.uncertainty}.size() : 1;
}

/// The comparison of departures as a share of all work for a window. A robust objective makes it smaller,
/// because many departures are then planned in full.
double share_of_comparison(const ocean::Environment& environment, const PlanRequest& request) {
  const auto seas = static_cast<double>(count_of_seas(environment, request));
  const auto departures = static_cast<double>(request.departures.departures(request.depart).size());
  const double plans = is_robust(environment, request) ? static_cast<double>(most_planned) : 1.0;
  const double comparison = seas * (searches_a_layout + departures);
  return comparison / (comparison + plans * seas * searches_a_plan);
}

bool is_cancelled(const std::vector<Result<Journey>>& journeys) {
  return std::ranges::any_of(journeys, [](const Result<Journey>& journey) {
    return !journey && journey.error().reason == Reason::cancelled;
  });
}

/// Sets the cost of each departure: the request's robust objective over the best routes in all members.
/// Returns  false once `stop` is requested
bool weigh_members(std::vector<DepartureOutcome>& outcomes, const ocean::Environment& environment,
                   const PlanRequest& request, const std::stop_token& stop, const core::Executor& executor,
                   const std::function<void(std::size_t, std::size_t)>& report) {
  const cost::SeaMembers members{environment, request.uncertainty};
  std::vector<core::UtcTime> departures;
  for (const DepartureOutcome& outcome : outcomes) departures.push_back(outcome.departure);
  std::vector<std::vector<std::optional<double>>> costs(outcomes.size());  // [departure][member]
  for (std::size_t member = 0; member < members.size(); ++member) {
    const auto journeys = leave_all(departures, members.environment(member), request, stop, executor,
                                    [&](std::size_t ended) { report(1 + member, ended); });
    if (is_cancelled(journeys)) return false;
    for (std::size_t i = 0; i < outcomes.size(); ++i)
      costs[i].push_back(journeys[i] ? std::optional{journeys[i]->cost} : std::nullopt);
  }
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    const MemberSpread spread{costs[i]};
    outcomes[i].robust_cost = what_counts(spread, request.uncertainty);
    outcomes[i].members_closed = members.size() - spread.known();
  }
  return true;
}

/// Replaces the estimated cost of a departure by the cost of its planned route over all members.
void count_plan(DepartureOutcome& outcome, const Plan& plan, const UncertaintyRules& rules) {
  const MemberSpread& costs = *plan.uncertainty->costs;
  outcome.robust_cost = what_counts(costs, rules);
  outcome.members_closed = plan.uncertainty->spread.travel_times().size() - costs.known();
}

/// The best of the departures that were planned in full. Departures that were not planned may be better.
std::size_t best_planned(const std::vector<DepartureOutcome>& outcomes,
                         const std::map<std::size_t, Plan>& planned, const Objective& objective) {
  std::vector<DepartureOutcome> of_planned;
  std::vector<std::size_t> departures;
  for (const auto& [departure, plan] : planned) {
    of_planned.push_back(outcomes[departure]);
    departures.push_back(departure);
  }
  return departures[*best_departure(of_planned, objective)];
}

}  // namespace

Result<std::vector<DepartureOutcome>> compare_departures(const ocean::Environment& environment,
                                                         const PlanRequest& request,
                                                         const std::stop_token& stop,
                                                         const core::ProgressCallback& progress,
                                                         const core::Executor& executor) {
  throw_if_invalid(request);
  const std::vector<core::UtcTime> departures = request.departures.departures(request.depart);
  const std::size_t seas = count_of_seas(environment, request);
  const auto report = [&](std::size_t sea, std::size_t departure) {
    if (!progress) return;
    // The grids are made with the first departure, so its progress counts them.
    const double searched = departure == 0 ? 0.0 : searches_a_layout + static_cast<double>(departure);
    const double done = searched / (searches_a_layout + static_cast<double>(departures.size()));
    progress("departures", (static_cast<double>(sea) + done) / static_cast<double>(seas));
  };

  report(0, 0);
  auto journeys = leave_all(departures, environment, request, stop, executor,
                            [&](std::size_t ended) { report(0, ended); });
  if (is_cancelled(journeys)) return tl::unexpected(search::explain_cancelled(request));
  std::vector<DepartureOutcome> outcomes;
  for (std::size_t i = 0; i < departures.size(); ++i) {
    DepartureOutcome outcome{.departure = departures[i]};
    if (Result<Journey>& found = journeys[i]) {
      outcome.travel_time = found->arrival - (departures[i] - request.depart);
      outcome.energy = found->energy;
    } else {
      outcome.closed = std::move(found.error());
    }
    outcomes.push_back(std::move(outcome));
  }
  if (seas > 1 && !weigh_members(outcomes, environment, request, stop, executor, report))
    return tl::unexpected(search::explain_cancelled(request));
  return outcomes;
}

WindowPlan try_to_plan_window(const ocean::Environment& environment, const PlanRequest& request,
                              const std::stop_token& stop, const core::ProgressCallback& progress,
                              const core::Executor& executor) {
  double done = share_of_comparison(environment, request);
  auto outcomes = compare_departures(environment, request, stop,
                                     core::part_of(progress, "departures", 0.0, done), executor);
  if (!outcomes) return {.departures = {}, .plan = tl::unexpected(outcomes.error())};
  std::optional<Infeasible> refused;
  std::map<std::size_t, Plan> planned;
  for (std::size_t tries = 0; tries < most_refused; ++tries) {
    const auto best = tries < best_refused || !planned.empty()
                          ? best_departure(*outcomes, request.energy.objective)
                          : furthest_from_refused(*outcomes);
    if (!best) break;
    if (const auto known = planned.find(*best); known != planned.end())
      return {.departures = std::move(*outcomes), .plan = std::move(known->second)};
    if (planned.size() == most_planned) break;
    DepartureOutcome& outcome = (*outcomes)[*best];
    // Usually the first plan succeeds and is the only one. With a robust objective `most_planned` plans are
    // made.
    const double share = outcome.robust_cost ? 1.0 / static_cast<double>(most_planned - planned.size()) : 0.9;
    const double from = std::exchange(done, done + share * (1.0 - done));
    auto plan = try_to_plan(environment, leaving_at(request, outcome.departure), stop,
                            core::part_of(progress, "best departure", from, done), executor);
    if (plan && outcome.robust_cost) {
      count_plan(outcome, *plan, request.uncertainty);
      planned.emplace(*best, std::move(*plan));
      continue;
    }
    if (plan || plan.error().reason == Reason::cancelled)
      return {.departures = std::move(*outcomes), .plan = std::move(plan)};
    // A full plan can fail although its route is open, for example for lack of energy. Then another departure
    // may succeed.
    outcome = {.departure = outcome.departure, .closed = plan.error()};
    if (!refused) refused = std::move(plan.error());
  }
  if (!planned.empty()) {
    Plan best = std::move(planned.at(best_planned(*outcomes, planned, request.energy.objective)));
    best.messages.push_back(
        messages::plan_message<"departures-not-all-planned">(outcomes->size(), planned.size()));
    return {.departures = std::move(*outcomes), .plan = std::move(best)};
  }
  Infeasible why = refused ? std::move(*refused) : outcomes->front().closed.value();
  const auto left = std::ranges::count_if(
      *outcomes, [](const DepartureOutcome& outcome) { return outcome.travel_time.has_value(); });
  if (left > 0) {
    why.besides.push_back(messages::refusal<"departures-tried">(most_refused, outcomes->size(), left));
  }
  return {.departures = std::move(*outcomes), .plan = tl::unexpected(std::move(why))};
}

std::optional<std::size_t> best_departure(const std::vector<DepartureOutcome>& outcomes,
                                          const Objective& objective) {
  constexpr double rounding = 1e-9;  // relative, of sums of times: such costs are equal
  std::optional<std::size_t> best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    const DepartureOutcome& outcome = outcomes[i];
    if (!outcome.travel_time) continue;
    const double cost = outcome.robust_cost.value_or(
        objective.cost(*outcome.travel_time, outcome.energy.value_or(core::Joules{})));
    const std::size_t most_closed = best ? outcomes[*best].members_closed : outcome.members_closed;
    if (outcome.members_closed > most_closed) continue;
    const bool is_cheaper = !best || outcome.members_closed < most_closed || cost < (1.0 - rounding) * least;
    if (!is_cheaper) continue;
    best = i;
    least = cost;
  }
  return best;
}

}  // namespace floeplan::planning::planner

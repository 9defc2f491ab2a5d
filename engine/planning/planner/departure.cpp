#include "engine/planning/planner/departure.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <map>
#include <mutex>
#include <stdexcept>
#include <utility>

#include "engine/messages/plan_messages.hpp"
#include "engine/messages/refusal_messages.hpp"
#include "engine/planning/cost/driven_route.hpp"
#include "engine/planning/cost/route_cost.hpp"
#include "engine/planning/cost/sea_members.hpp"
#include "engine/planning/planner/cost_plan.hpp"
#include "engine/planning/planner/robust_plan.hpp"
#include "engine/planning/planner/strategies.hpp"
#include "engine/planning/search/chart.hpp"
#include "engine/planning/search/energy/cost_search.hpp"
#include "engine/planning/search/explanation.hpp"
#include "engine/planning/search/grid/open_grid.hpp"
#include "engine/planning/search/voyage_grids.hpp"
#include "engine/planning/search/voyage_search.hpp"

namespace floeplan::planning::planner {
namespace {

/// Work of a time-reversed search from the goal; unit: the search for one departure.
constexpr double departures_a_sweep = 2.0;

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

/// Number of environments in which each departure is searched: the first, and with a robust objective those
/// of all members.
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

/// The result of one departure in a search area of one size.
struct Journey {
  core::Seconds arrival{};
  core::Joules energy{};
  double cost{};  // by the request's objective
  bool touches_rim{false};
};

/// A search area of one size, gridded for all departures.
struct Ground {
  PlanRequest request;
  search::Chart chart;
  std::vector<search::OpenGrid> grids;  // empty for a straight route
  std::vector<Ground> fastest;          // for each propulsion alone, if the objective is not time
};

/// Errors   as draw_chart
Result<Ground> lay_out(const ocean::Environment& environment, const PlanRequest& request,
                       cost::GridReach reach, const std::stop_token& stop) {
  // Searches for the least cost do not hold; only fastest routes do.
  PlanRequest drawn = request;
  if (!request.energy.objective.is_time()) drawn.holds.longest = core::Seconds{0.0};
  auto chart = search::draw_chart(environment, drawn, reach, stop);
  if (!chart) return tl::unexpected(chart.error());
  Ground ground{request, std::move(*chart), {}, {}};
  if (request.method != Method::direct)
    ground.grids = search::open_grids(ground.chart.sea, ground.chart.layout.grids, request.sectors, stop);
  if (request.energy.objective.is_time()) return ground;
  for (const vehicle::Drive drive : drives(request.energy, request.vehicle)) {
    auto other = lay_out(environment, fastest_request(request, drive), reach, stop);
    if (!other) return other;
    ground.fastest.push_back(std::move(*other));
  }
  return ground;
}

/// The search areas of a request. Each is gridded when it is first needed.
/// Threads  members may be called from several threads at once
class Grounds {
 public:
  /// All references are borrowed and must outlive this.
  Grounds(const ocean::Environment& environment, const PlanRequest& request, const std::stop_token& stop)
      : environment_{environment}, request_{request}, stop_{stop} {}

  [[nodiscard]] const Result<Ground>& near() { return laid_out(near_, cost::reaches(request_).front()); }
  [[nodiscard]] const Result<Ground>& wide() { return laid_out(wide_, cost::reaches(request_).back()); }

 private:
  const Result<Ground>& laid_out(std::optional<Result<Ground>>& ground, cost::GridReach reach) {
    const std::lock_guard lock{mutex_};
    if (!ground) ground.emplace(lay_out(environment_, request_, reach, stop_));
    return *ground;
  }

  const ocean::Environment& environment_;
  const PlanRequest& request_;
  const std::stop_token& stop_;
  std::mutex mutex_;
  std::optional<Result<Ground>> near_;
  std::optional<Result<Ground>> wide_;
};

/// Searches the grids of one search area for one departure after another.
class DepartureSweep {
 public:
  /// `ground` is borrowed and must outlive this.
  explicit DepartureSweep(const Ground& ground) : ground_{ground} {
    const PlanRequest& request = ground.request;
    const core::Seconds ahead = departures_a_sweep * request.departures.step;
    const core::Seconds window = request.departures.departures(request.depart).back() - request.depart;
    for (const search::OpenGrid& open : ground.grids) {
      if (request.energy.objective.is_time()) {
        foresights_.emplace_back(ground.chart.sea, open, ahead);
      } else {
        guides_.emplace_back(ground.chart.sea, open, window);
      }
    }
    for (const Ground& each : ground.fastest) fastest_.emplace_back(each);
  }

  /// The route of least cost for the departure `after`, as a plan for this departure alone would choose it.
  Result<Journey> leave(core::Seconds after, const std::stop_token& stop) {
    const PlanRequest& request = ground_.request;
    if (auto closed = search::closed_start(ground_.chart, request, after))
      return tl::unexpected(std::move(*closed));
    if (request.energy.objective.is_time()) return earliest(after, stop);
    Result<Journey> best = request.method == Method::direct ? straight(after) : cheapest(after, stop);
    for (DepartureSweep& sweep : fastest_) {
      if (stop.stop_requested()) return tl::unexpected(search::explain_cancelled(request));
      auto other = sweep.leave(after, stop);
      if (!other) continue;
      other->cost = cost(other->arrival - after, other->energy);
      if (!best || other->cost < best->cost) best = std::move(other);
    }
    return best;
  }

 private:
  Result<Journey> earliest(core::Seconds after, const std::stop_token& stop) {
    if (ground_.request.method == Method::direct) return straight(after);
    auto found =
        search::search_voyage(ground_.chart.sea, ground_.grids, ground_.request, after, stop, [](double) {},
                              {.way = last_ ? &*last_ : nullptr, .foresights = &foresights_});
    if (!found) return tl::unexpected(std::move(found.error()));
    last_ = std::move(*found);
    return on_first_drive(last_->route.points, last_->touches_rim, after);
  }

  Result<Journey> straight(core::Seconds after) const {
    return on_first_drive(ground_.chart.layout.points, false, after);
  }

  Result<Journey> cheapest(core::Seconds after, const std::stop_token& stop) {
    const cost::Sea& sea = ground_.chart.sea;
    const auto found =
        search::search_least_cost(sea, ground_.grids, ground_.request, after, stop, [](double) {}, &guides_);
    if (!found) return tl::unexpected(found.error());
    const auto times = cost::drive_along(sea, found->route, after);
    if (!times) {
      const cost::RouteClosed closed{.reason = times.error(), .at = found->route.points.front()};
      return tl::unexpected(search::explain_route(closed, sea, ground_.request));
    }
    return journey(times->arrivals, times->energy, found->touches_rim);
  }

  Result<Journey> on_first_drive(const std::vector<geo::PlanePoint>& points, bool touches_rim,
                                 core::Seconds after) const {
    const cost::Sea& sea = ground_.chart.sea;
    const auto arrivals = cost::arrivals_along(sea, points, after);
    if (!arrivals) return tl::unexpected(search::explain_route(arrivals.error(), sea, ground_.request));
    EnergyUse energy;
    for (std::size_t i = 1; i < points.size(); ++i) {
      energy += sea.energy_along(points[i - 1], points[i], (*arrivals)[i - 1],
                                 (*arrivals)[i] - (*arrivals)[i - 1], sea.drives().front());
    }
    return journey(*arrivals, energy, touches_rim);
  }

  [[nodiscard]] Journey journey(const std::vector<core::Seconds>& arrivals, const EnergyUse& energy,
                                bool touches_rim) const {
    const core::Seconds time = arrivals.back() - arrivals.front();
    return {arrivals.back(), energy.total(), cost(time, energy.total()), touches_rim};
  }

  [[nodiscard]] double cost(core::Seconds time, core::Joules energy) const {
    return ground_.request.energy.objective.cost(time, energy);
  }

  const Ground& ground_;
  std::vector<search::Foresight> foresights_;  // one for each grid, if the objective is time
  std::vector<search::CostGuide> guides_;      // one for each grid, for other objectives
  std::optional<search::FoundWay> last_;       // route of the departure before
  std::vector<DepartureSweep> fastest_;        // with each propulsion alone
};

/// Whether a larger search area may hold a route although this one does not.
bool may_be_mended(Reason why) {
  return why != Reason::cancelled && why != Reason::start_near_iceberg && why != Reason::start_in_zone;
}

/// Searches departures, each in the smaller or the larger area, as a plan for that departure alone would
/// choose.
class Comparison {
 public:
  /// `grounds` and `request` are borrowed and must outlive this.
  Comparison(Grounds& grounds, const PlanRequest& request) : grounds_{grounds}, request_{request} {}

  Result<Journey> leave(core::Seconds after, const std::stop_token& stop) {
    auto first = on(near_, grounds_.near(), after, stop);
    const bool wider_may_help = first ? first->touches_rim : may_be_mended(first.error().reason);
    if (!wider_may_help || cost::reaches(request_).size() == 1 || request_.method == Method::direct)
      return first;
    auto second = on(wide_, grounds_.wide(), after, stop);
    if (first && (!second || first->cost <= second->cost)) return first;
    return second;
  }

 private:
  static Result<Journey> on(std::optional<DepartureSweep>& sweep, const Result<Ground>& ground,
                            core::Seconds after, const std::stop_token& stop) {
    if (!ground) return tl::unexpected(ground.error());
    if (!sweep) sweep.emplace(*ground);
    return sweep->leave(after, stop);
  }

  Grounds& grounds_;
  const PlanRequest& request_;
  std::optional<DepartureSweep> near_;
  std::optional<DepartureSweep> wide_;
};

/// Departures per piece of work. The first of a piece takes twice the time of the others: no earlier route
/// bounds it.
constexpr std::size_t departures_a_piece = 8;

/// The result for each departure in one environment. Departures after a requested stop are cancelled.
/// `ended`  called with the number of finished departures
std::vector<Result<Journey>> leave_all(const std::vector<core::UtcTime>& departures,
                                       const ocean::Environment& environment, const PlanRequest& request,
                                       const std::stop_token& stop, const core::Executor& executor,
                                       const std::function<void(std::size_t)>& ended) {
  Grounds grounds{environment, request, stop};
  std::vector<Result<Journey>> journeys(departures.size(),
                                        tl::unexpected(search::explain_cancelled(request)));
  const std::size_t pieces = (departures.size() + departures_a_piece - 1) / departures_a_piece;
  core::CountOfEnded count{ended};
  executor.run(pieces, [&](std::size_t piece, bool is_caller) {
    Comparison comparison{grounds, request};
    const std::size_t first = piece * departures.size() / pieces;
    const std::size_t end = (piece + 1) * departures.size() / pieces;
    for (std::size_t i = first; i < end && !stop.stop_requested(); ++i) {
      journeys[i] = comparison.leave(departures[i] - request.depart, stop);
      count.add(is_caller);
    }
  });
  return journeys;
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

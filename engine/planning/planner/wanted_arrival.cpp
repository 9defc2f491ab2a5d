#include "engine/planning/planner/wanted_arrival.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/core/utc_text.hpp"
#include "engine/messages/plan_messages.hpp"
#include "engine/messages/refusal_messages.hpp"
#include "engine/planning/cost/hold_times.hpp"
#include "engine/planning/cost/route_cost.hpp"
#include "engine/planning/planner/departure.hpp"
#include "engine/planning/planner/robust_plan.hpp"
#include "engine/planning/planner/strategies.hpp"
#include "engine/planning/search/chart.hpp"
#include "engine/planning/search/explanation.hpp"
#include "engine/planning/search/latest_departure.hpp"
#include "engine/planning/search/voyage_grids.hpp"

namespace floeplan::planning::planner {
namespace {

constexpr core::Seconds close_enough{60.0};
constexpr double close_enough_share = 1e-3;  // of the travel time
constexpr int most_plans = 16;  // enough to halve a day to within two seconds, finer than `close_enough`

/// Where the search for the departure begins.
struct Beginning {
  core::UtcTime
      depart;  // estimated from the legs of the grids; the earliest departure if the grids hold no route
  core::UtcTime arrive;  // the last time up to the wanted arrival at which the goal is open
  core::UtcTime
      holds_until;  // a vehicle that is at the start from the earliest departure on can hold there till then
  std::optional<search::Chart> chart{};  // the search area of the estimate
};

core::Seconds last_open_moment(const cost::Sea& sea, geo::PlanePoint place, core::Seconds until) {
  constexpr core::Seconds clear{1.0};
  for (const TimeSpan& closed : sea.domain().closures().closed_times(place))
    if (closed.from <= until && until <= closed.until) return closed.from - clear;
  return until;
}

/// How long after the earliest departure the vehicle can hold at the start; at most `until`.
core::Seconds stays_at_the_start(const cost::Sea& sea, geo::PlanePoint start, core::Seconds until) {
  constexpr core::Seconds earliest{0.0};
  const core::Seconds longest = std::min(sea.holding().longest, until);
  return longest > earliest ? cost::can_stay_until(sea, start, earliest, longest) : earliest;
}

/// The latest departure with which a vehicle on the plan's route is at the goal by `wanted`. Empty if that is
/// not later than the plan's departure, or if the arrival of the plan is not that of its route alone.
std::optional<core::UtcTime> latest_on_the_same_route(const Plan& plan, core::UtcTime arrival_of_plan,
                                                      const search::Chart& chart, core::UtcTime epoch,
                                                      core::UtcTime wanted) {
  constexpr int most_steps = 8;  // each divides the error by ten or more where currents change over hours
  constexpr core::Seconds whole{1.0};
  std::vector<geo::PlanePoint> points;
  for (const Waypoint& waypoint : plan.waypoints)
    points.push_back(chart.layout.projection.to_plane(waypoint.place));
  const auto spare_if_left_at = [&](core::Seconds depart) -> std::optional<core::Seconds> {
    const auto arrivals = cost::arrivals_along(chart.sea, points, depart);
    if (!arrivals) return std::nullopt;
    return (wanted - epoch) - arrivals->back();
  };
  core::Seconds depart = plan.departure - epoch;
  auto spare = spare_if_left_at(depart);
  if (!spare || std::abs((*spare - (wanted - arrival_of_plan)).count()) > close_enough.count())
    return std::nullopt;
  std::optional<core::UtcTime> latest;
  for (int step = 0; step < most_steps && spare && std::abs(spare->count()) > whole.count(); ++step) {
    depart += *spare;
    spare = spare_if_left_at(depart);
    if (spare && spare->count() >= 0.0 && epoch + depart > plan.departure) latest = epoch + depart;
  }
  return latest;
}

Result<Beginning> begin(const ocean::Environment& environment, const PlanRequest& request,
                        const std::stop_token& stop) {
  constexpr core::Seconds earliest{0.0};
  Beginning beginning{request.depart, *request.departures.arrive_by, request.depart};
  for (const cost::GridReach reach : cost::reaches(request)) {
    auto drawn = search::draw_chart(environment, request, reach, stop);
    if (!drawn) return tl::unexpected(std::move(drawn.error()));
    const search::Chart& chart = beginning.chart.emplace(std::move(*drawn));
    const core::Seconds arrive = last_open_moment(chart.sea, chart.layout.points.back(),
                                                  *request.departures.arrive_by - request.depart);
    if (arrive > earliest) beginning.arrive = request.depart + arrive;
    beginning.holds_until =
        request.depart + stays_at_the_start(chart.sea, chart.layout.points.front(), arrive);
    if (request.method == Method::direct) break;
    const auto grids = search::open_grids(chart.sea, chart.layout.grids, request.sectors, stop);
    const auto depart = search::latest_departure(chart.sea, grids, arrive, earliest, stop);
    if (stop.stop_requested()) return tl::unexpected(search::explain_cancelled(request));
    if (!depart) continue;
    beginning.depart = request.depart + *depart;
    break;
  }
  return beginning;
}

core::UtcTime whole_second(core::UtcTime time) {
  return core::from_unix_seconds(std::floor(core::unix_seconds(time)));
}

Infeasible too_early(const PlanRequest& request, const Plan& earliest) {
  const core::UtcTime wanted = *request.departures.arrive_by;
  const core::UtcTime arrival = arrival_that_counts(earliest, request.uncertainty);
  Infeasible why{
      .reason = Reason::arrival_too_early, .at = request.to, .when = wanted, .binding = Constraint::caller};
  if (!std::isfinite(core::unix_seconds(arrival))) {
    why.why = messages::refusal<"earliest-departure-in-too-few-members">(request.depart).at(request.to);
    return why;
  }
  const core::UtcTime possible = core::from_unix_seconds(std::ceil(core::unix_seconds(arrival)));
  why.why = messages::refusal<"earliest-departure-too-late">(request.depart, possible).at(request.to);
  why.changes = {{"arrive_by", wanted, possible, "arrive by " + core::iso8601(possible)}};
  return why;
}

core::UtcTime between(core::UtcTime early, core::UtcTime late) {
  return whole_second(early + 0.5 * (late - early));
}

/// Searches for the latest departure that arrives in time.
class LatestDeparture {
 public:
  /// All references are borrowed and must outlive this.
  LatestDeparture(const ocean::Environment& environment, const PlanRequest& request,
                  const std::stop_token& stop, const core::ProgressCallback& progress,
                  const core::Executor& executor)
      : environment_{environment},
        request_{request},
        wanted_{*request.departures.arrive_by},
        stop_{stop},
        executor_{executor},
        parts_{progress, "latest departure"} {}

  Result<Plan> find() {
    auto beginning = begin(environment_, request_, stop_);
    if (!beginning) return tl::unexpected(std::move(beginning.error()));
    chart_ = std::move(beginning->chart);
    wanted_ = beginning->arrive;
    holds_until_ = beginning->holds_until;
    climb(std::max(whole_second(beginning->depart), request_.depart));
    if (!is_cancelled() && !is_late_enough() && !is_closed_for_good() && !earlier_is_in_time_too())
      look_through_the_rest();
    if (is_cancelled()) return tl::unexpected(search::explain_cancelled(request_));
    if (!best_) return explained();
    wanted_ = *request_.departures.arrive_by;
    if (!is_late_enough()) best_->messages.push_back(early());
    if (best_->arrival > wanted_) best_->messages.push_back(late());
    return std::move(*best_);
  }

 private:
  static constexpr int samples = 16;  // departures tried between the best one and the wanted arrival

  [[nodiscard]] bool is_cancelled() const { return stop_.stop_requested(); }
  [[nodiscard]] core::Seconds left(const Plan& plan) const {
    return wanted_ - arrival_that_counts(plan, request_.uncertainty);
  }
  [[nodiscard]] bool is_late_enough() const {
    return best_ && left(*best_) <= std::max(close_enough, close_enough_share * best_->travel_time());
  }

  /// Whether the cause of every failed plan is permanent, so that other departures need not be tried.
  [[nodiscard]] bool is_closed_for_good() const {
    if (some_arrive_ || !binds_) return false;
    return binds_ == Constraint::land || binds_ == Constraint::depth || binds_ == Constraint::data_area ||
           binds_ == Constraint::memory;
  }

  /// Whether every departure earlier than one in time is in time, too: the vehicle may hold at the start
  /// until the later one. Without such a hold, closures may make an earlier departure arrive too late.
  [[nodiscard]] bool earlier_is_in_time_too() const {
    return request_.energy.objective.is_time() && request_.uncertainty.objective == RobustObjective::none &&
           request_.method == Method::astar && holds_until_ >= wanted_ - least_travel_time();
  }

  /// Makes a whole plan for a departure. If it arrives in time, keeps it when it departs later than the best
  /// plan so far.
  /// Returns the time left until the wanted arrival, negative if late; empty if there is no plan.
  std::optional<core::Seconds> try_at(core::UtcTime depart) {
    auto plan =
        try_to_plan(environment_, leaving_at(request_, depart), stop_, parts_.next(), executor_, route_);
    onward_.reset();
    route_.clear();
    if (!plan) {
      binds_ = plan.error().binding;
      return std::nullopt;
    }
    const core::Seconds spare = left(*plan);
    some_arrive_ = true;
    for (const Waypoint& waypoint : plan->waypoints) route_.push_back(waypoint.place);
    if (spare.count() > 0.0)
      onward_ = latest_on_the_same_route(*plan, wanted_ - spare, *chart_, request_.depart, wanted_);
    if (spare.count() >= 0.0 && (!best_ || plan->departure > best_->departure)) best_ = std::move(*plan);
    return spare;
  }

  /// Moves the departure later, as far as the route of the last plan allows, or by the time left until the
  /// wanted arrival; or earlier by the time missing. Under FIFO all converge to the latest departure in time.
  /// `fails`: a departure known not to be in time
  void climb(core::UtcTime depart, std::optional<core::UtcTime> fails = std::nullopt) {
    for (int tries = 0; tries < most_plans && !is_cancelled(); ++tries) {
      const auto spare = try_at(depart);
      if (is_late_enough()) return;
      if (spare && spare->count() >= 0.0 && !fails) {
        depart = whole_second(onward_.value_or(depart + *spare));
        continue;
      }
      if (!spare || spare->count() < 0.0) fails = depart;
      if (best_) {
        if (*fails - best_->departure < close_enough) return;
        depart = between(best_->departure, *fails);
        continue;
      }
      if (!spare || depart <= request_.depart) return;
      const core::Seconds back = std::isfinite(spare->count()) ? -*spare : 0.5 * (depart - request_.depart);
      depart = std::max(whole_second(depart - back - close_enough), request_.depart);
    }
  }

  /// Compares departures after the best one, or all if there is none. The search continues from the latest of
  /// them that is in time.
  void look_through_the_rest() {
    PlanRequest window = request_;
    if (best_) window.depart = best_->departure;
    const core::Seconds least = least_travel_time();
    window.departures = {.until = wanted_ - least, .step = (wanted_ - least - window.depart) / samples};
    if (window.departures.step < close_enough) return;
    window.uncertainty.objective = RobustObjective::none;  // members are used in the whole plans only
    const auto curve = compare_departures(environment_, window, stop_, parts_.next(), executor_);
    if (!curve) return;
    std::optional<core::UtcTime> fails;
    for (std::size_t i = curve->size(); i-- > 0 && !is_cancelled();) {
      const DepartureOutcome& outcome = (*curve)[i];
      if (best_ && outcome.departure <= best_->departure) return;
      const bool is_in_time = outcome.travel_time && outcome.arrival() <= wanted_;
      if (is_in_time) climb(whole_second(outcome.departure), fails);
      fails = outcome.departure;
      if (is_in_time && best_ && best_->departure >= whole_second(outcome.departure)) return;
    }
  }

  /// A rough lower bound of the travel time: a quarter of the best plan's travel time, in case of strong
  /// currents from astern; zero without a best plan.
  [[nodiscard]] core::Seconds least_travel_time() const {
    if (!best_) return core::Seconds{0.0};
    return 0.25 * best_->travel_time();
  }

  [[nodiscard]] messages::Message early() const {
    return messages::plan_message<"early-arrival">(left(*best_).count() / 3600.0);
  }

  /// The message for a plan that arrives in time by the mean or quantile over all members, but too late in
  /// the currents of the first member.
  [[nodiscard]] messages::Message late() const {
    const bool is_quantile = request_.uncertainty.objective == RobustObjective::quantile;
    return messages::plan_message<"late-in-first-currents">(
        best_->arrival, is_quantile ? "quantile" : "mean", arrival_that_counts(*best_, request_.uncertainty));
  }

  /// The reason why no departure is in time; or the plan of the earliest departure, if that is in time after
  /// all.
  Result<Plan> explained() {
    auto earliest =
        try_to_plan(environment_, leaving_at(request_, request_.depart), stop_, parts_.next(), executor_);
    if (earliest && left(*earliest).count() >= 0.0) return earliest;
    if (earliest) return tl::unexpected(too_early(request_, *earliest));
    return earliest;
  }

  const ocean::Environment& environment_;
  const PlanRequest& request_;
  core::UtcTime holds_until_;  // as in Beginning
  core::UtcTime wanted_;       // the wanted arrival, or the last time before at which the goal is open
  const std::stop_token& stop_;
  const core::Executor& executor_;
  core::PartsOfProgress parts_;
  std::optional<search::Chart> chart_;   // as in Beginning
  std::vector<geo::LonLat> route_;       // of the plan tried last; empty: there was none
  std::optional<core::UtcTime> onward_;  // the latest departure on that route
  std::optional<Plan> best_;             // the latest departure found that is in time
  bool some_arrive_{false};              // whether any tried departure arrived, even late
  std::optional<Constraint> binds_;      // what stopped the last departure without a plan
};

}  // namespace

Result<Plan> try_to_plan_arrival(const ocean::Environment& environment, const PlanRequest& request,
                                 const std::stop_token& stop, const core::ProgressCallback& progress,
                                 const core::Executor& executor) {
  return LatestDeparture{environment, request, stop, progress, executor}.find();
}

}  // namespace floeplan::planning::planner

#include "engine/planning/robust_plan.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include "engine/planning/chart.hpp"
#include "engine/planning/evaluate_route.hpp"
#include "engine/planning/explanation.hpp"
#include "engine/planning/route_cost.hpp"

namespace floeplan::planning {
namespace {

constexpr core::Seconds at_departure{0.0};

/// The seas of an ensemble, or of an error model drawn one at a time: only the one at work is in memory.
class Members {
 public:
  Members(const ocean::Environment& environment, const UncertaintyRules& rules)
      : environment_{environment}, rules_{rules} {}

  [[nodiscard]] std::size_t size() const {
    return rules_.drawn_members > 0 ? static_cast<std::size_t>(rules_.drawn_members)
                                    : environment_.members.size();
  }

  [[nodiscard]] ocean::Environment environment(std::size_t member) const {
    ocean::Environment result = environment_;
    result.members.clear();
    if (rules_.drawn_members > 0) {
      std::seed_seq seeds{static_cast<std::uint32_t>(rules_.seed),
                          static_cast<std::uint32_t>(rules_.seed >> 32), static_cast<std::uint32_t>(member)};
      std::mt19937_64 rng{seeds};
      result.currents = std::make_shared<const ocean::CurrentGrid>(
          ocean::with_error(*environment_.currents, rules_.error, rng));
    } else {
      result.currents = environment_.members[member];
    }
    return result;
  }

 private:
  const ocean::Environment& environment_;
  const UncertaintyRules& rules_;
};

std::vector<geo::LonLat> places_of(const Plan& plan) {
  std::vector<geo::LonLat> places;
  for (const Waypoint& waypoint : plan.waypoints) places.push_back(waypoint.place);
  return places;
}

std::optional<core::Seconds> travel_time(const Chart& chart, const std::vector<geo::LonLat>& places) {
  std::vector<geo::PlanePoint> points;
  for (const geo::LonLat place : places) points.push_back(chart.layout.projection.to_plane(place));
  const auto arrivals = arrivals_along(chart.sea, points, at_departure);
  if (!arrivals) return std::nullopt;
  return arrivals->back() - at_departure;
}

/// What the objective counts of a spread, less is better.
double criterion_s(const ArrivalSpread& spread, const UncertaintyRules& rules) {
  const auto time =
      rules.objective == RobustObjective::quantile ? spread.quantile(rules.quantile) : spread.mean();
  return time ? time->count() : std::numeric_limits<double>::infinity();
}

bool is_better(const ArrivalSpread& a, const ArrivalSpread& b, const UncertaintyRules& rules) {
  if (a.arrived() != b.arrived()) return a.arrived() > b.arrived();
  return criterion_s(a, rules) < criterion_s(b, rules);
}

UncertaintyReport report_of(ArrivalSpread spread, const UncertaintyRules& rules, core::UtcTime depart,
                            std::size_t candidates) {
  UncertaintyReport report{.spread = std::move(spread),
                           .objective = rules.objective,
                           .quantile = rules.quantile,
                           .candidates = candidates,
                           .arrive_before = rules.arrive_before,
                           .chance = {}};
  if (rules.arrive_before) report.chance = report.spread.chance_within(*rules.arrive_before - depart);
  return report;
}

}  // namespace

bool has_uncertain_currents(const ocean::Environment& environment, const PlanRequest& request) {
  return environment.currents && (request.uncertainty.drawn_members > 0 || environment.members.size() > 1);
}

Result<Plan> plan_uncertain(const ocean::Environment& environment, const PlanRequest& request,
                            const PlanIn& plan_in, const std::stop_token& stop,
                            const core::ProgressCallback& progress) {
  const UncertaintyRules& rules = request.uncertainty;
  const Members members{environment, rules};
  Result<Plan> base = plan_in(environment);
  if (!base) return base;

  std::vector<std::vector<geo::LonLat>> candidates{places_of(*base)};
  const auto report = [&](double from, std::size_t member) {
    progress("members", from + 0.5 * static_cast<double>(member) / static_cast<double>(members.size()));
  };
  for (std::size_t member = 0; rules.objective != RobustObjective::none && member < members.size();
       ++member) {
    if (stop.stop_requested()) return tl::unexpected(explain_cancelled(request));
    report(0.0, member);
    const ocean::Environment sea = members.environment(member);
    const Result<Plan> plan = plan_in(sea);
    // A route that the first currents do not let through could not be published.
    if (plan && evaluate_route(environment, places_of(*plan), request, stop))
      candidates.push_back(places_of(*plan));
  }

  std::vector<std::vector<std::optional<core::Seconds>>> times(candidates.size());
  for (std::size_t member = 0; member < members.size(); ++member) {
    if (stop.stop_requested()) return tl::unexpected(explain_cancelled(request));
    report(0.5, member);
    const ocean::Environment sea = members.environment(member);
    const Result<Chart> chart = draw_chart(sea, request, second_reach, stop);
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      times[i].push_back(chart ? travel_time(*chart, candidates[i]) : std::nullopt);
    }
  }
  if (stop.stop_requested()) return tl::unexpected(explain_cancelled(request));

  std::vector<ArrivalSpread> spreads;
  for (auto& each : times) spreads.emplace_back(std::move(each));
  std::size_t best = 0;
  for (std::size_t i = 1; i < spreads.size(); ++i) {
    if (is_better(spreads[i], spreads[best], rules)) best = i;
  }
  if (best != 0) {
    Result<Plan> chosen = evaluate_route(environment, candidates[best], request, stop);
    if (!chosen) return chosen;
    chosen->method = base->method;
    chosen->search = base->search;
    base = std::move(chosen);
  }
  base->uncertainty = report_of(spreads[best], rules, request.depart, candidates.size());
  return base;
}

}  // namespace floeplan::planning

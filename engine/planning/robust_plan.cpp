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
#include "engine/planning/driven_route.hpp"
#include "engine/planning/evaluate_route.hpp"
#include "engine/planning/explanation.hpp"
#include "engine/planning/member_spread.hpp"

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
  places.reserve(plan.waypoints.size());
  for (const Waypoint& waypoint : plan.waypoints) places.push_back(waypoint.place);
  return places;
}

/// The plan's legs on the drives that it has in the first currents: they are what is flown, whichever currents come true.
DrivenRoute route_of(const Plan& plan, const geo::LocalProjection& projection) {
  DrivenRoute route;
  for (const Waypoint& waypoint : plan.waypoints) {
    route.points.push_back(projection.to_plane(waypoint.place));
    route.fixed.push_back(true);
    if (waypoint.drive) route.drives.push_back(*waypoint.drive);
  }
  return route;
}

/// How a plan fares in each member.
class Fares {
 public:
  void add(const Chart& chart, const DrivenRoute& route, const Objective& objective) {
    const auto times = drive_in_time(chart.sea, route, at_departure);
    times_.push_back(times ? std::optional{times->arrivals.back() - at_departure} : std::nullopt);
    costs_.push_back(times ? std::optional{times->cost(objective)} : std::nullopt);
  }
  void add_closed() {
    times_.emplace_back();
    costs_.emplace_back();
  }

  [[nodiscard]] ArrivalSpread arrivals() const { return ArrivalSpread{times_}; }
  [[nodiscard]] MemberSpread costs() const { return MemberSpread{costs_}; }

 private:
  std::vector<std::optional<core::Seconds>> times_;
  std::vector<std::optional<double>> costs_;
};

/// What the objective counts of a plan's costs in the members, less is better.
double criterion(const MemberSpread& costs, const UncertaintyRules& rules) {
  const auto cost =
      rules.objective == RobustObjective::quantile ? costs.quantile(rules.quantile) : costs.mean();
  return cost.value_or(std::numeric_limits<double>::infinity());
}

bool is_better(const MemberSpread& a, const MemberSpread& b, const UncertaintyRules& rules) {
  if (a.known() != b.known()) return a.known() > b.known();
  return criterion(a, rules) < criterion(b, rules);
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

  std::vector<Plan> candidates{*base};
  const auto report = [&](double from, std::size_t member) {
    progress("members", from + 0.5 * static_cast<double>(member) / static_cast<double>(members.size()));
  };
  for (std::size_t member = 0; rules.objective != RobustObjective::none && member < members.size();
       ++member) {
    if (stop.stop_requested()) return tl::unexpected(explain_cancelled(request));
    report(0.0, member);
    const ocean::Environment sea = members.environment(member);
    const Result<Plan> plan = plan_in(sea);
    if (!plan) continue;
    // A route that the first currents do not let through could not be published.
    Result<Plan> in_first = evaluate_route(environment, places_of(*plan), request, stop);
    if (in_first) candidates.push_back(std::move(*in_first));
  }

  const Objective objective = request.objective();
  std::vector<Fares> fares(candidates.size());
  for (std::size_t member = 0; member < members.size(); ++member) {
    if (stop.stop_requested()) return tl::unexpected(explain_cancelled(request));
    report(0.5, member);
    const ocean::Environment sea = members.environment(member);
    const Result<Chart> chart = draw_chart(sea, request, second_reach, stop);
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      if (chart) {
        fares[i].add(*chart, route_of(candidates[i], chart->layout.projection), objective);
      } else {
        fares[i].add_closed();
      }
    }
  }
  if (stop.stop_requested()) return tl::unexpected(explain_cancelled(request));

  std::vector<MemberSpread> costs;
  costs.reserve(fares.size());
  for (const Fares& each : fares) costs.push_back(each.costs());
  std::size_t best = 0;
  for (std::size_t i = 1; i < costs.size(); ++i) {
    if (is_better(costs[i], costs[best], rules)) best = i;
  }
  Plan& chosen = candidates[best];
  chosen.method = base->method;
  chosen.search = base->search;
  chosen.encounter_trade = base->encounter_trade;
  chosen.uncertainty = report_of(fares[best].arrivals(), rules, request.depart, candidates.size());
  return std::move(chosen);
}

}  // namespace floeplan::planning

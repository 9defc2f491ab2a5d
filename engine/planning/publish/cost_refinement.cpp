#include "engine/planning/publish/cost_refinement.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "engine/planning/cost/route.hpp"
#include "engine/planning/refinement/shortening.hpp"

namespace floeplan::planning::publish {
namespace {

/// Share of the cost. Points that together save less are removed, as a longer refinement might have done.
/// Equal to the gain that doubling the legs must bring.
constexpr double worth_points = 1e-3;

/// Times and costs of legs for refinement: each leg uses the cheapest propulsion.
class CheapestLeg {
 public:
  /// `sea` is borrowed.
  CheapestLeg(const cost::Sea& sea, const Objective& objective) : sea_{sea}, objective_{objective} {}

  std::optional<cost::LegCost> operator()(geo::PlanePoint a, geo::PlanePoint b, core::Seconds depart) const {
    std::optional<cost::LegCost> cheapest;
    for (const vehicle::Drive drive : sea_.drives()) keep_cheaper(cheapest, on(drive, a, b, depart));
    return cheapest;
  }

  /// The propulsion with which the leg costs least; the first one if the leg is closed to all.
  [[nodiscard]] vehicle::Drive drive(geo::PlanePoint a, geo::PlanePoint b, core::Seconds depart) const {
    vehicle::Drive best = sea_.drives().front();
    std::optional<cost::LegCost> cheapest;
    for (const vehicle::Drive drive : sea_.drives()) {
      if (keep_cheaper(cheapest, on(drive, a, b, depart))) best = drive;
    }
    return best;
  }

 private:
  [[nodiscard]] std::optional<cost::LegCost> on(vehicle::Drive drive, geo::PlanePoint a, geo::PlanePoint b,
                                                core::Seconds depart) const {
    const auto driven = sea_.metered_leg(a, b, depart, core::Seconds{0.0}, core::Seconds{INFINITY}, drive);
    if (!driven) return std::nullopt;
    const core::Seconds time = driven->leg.time;
    return cost::LegCost{time,
                         objective_.cost(time, driven->energy.total(), sea_.encounters(a, b, depart, time))};
  }

  static bool keep_cheaper(std::optional<cost::LegCost>& cheapest, const std::optional<cost::LegCost>& leg) {
    if (!leg || (cheapest && cheapest->cost <= leg->cost)) return false;
    cheapest = leg;
    return true;
  }

  const cost::Sea& sea_;
  Objective objective_;
};

cost::DrivenRoute on_cheapest_drives(const CheapestLeg& leg, const cost::Itinerary& timed) {
  cost::DrivenRoute result{.points = timed.route.points, .fixed = timed.route.fixed, .drives = {}};
  for (std::size_t i = 1; i < result.points.size(); ++i)
    result.drives.push_back(leg.drive(result.points[i - 1], result.points[i], timed.times[i - 1]));
  return result;
}

}  // namespace

RefinedDrive refine_drive(const cost::Sea& sea, const cost::DrivenRoute& route, const Objective& objective,
                          const refinement::RefinementLimits& limits,
                          const refinement::RefinementBudget& budget) {
  RefinedDrive result{.route = route, .report = {}};
  const auto before = cost::drive_along(sea, route, cost::at_departure);
  if (!before) return result;
  const CheapestLeg leg{sea, objective};
  refinement::LegMeter legs{leg, budget};
  const auto start = legs.timed({route.points, route.fixed}, cost::at_departure);
  if (!start) return result;
  std::vector<cost::Itinerary> shorter;
  if (limits.most_legs) shorter.push_back(refinement::shorten_to(legs, *start, *limits.most_legs));
  refinement::Refined refined = refinement::refine_route(leg, *start, limits, budget, shorter);
  result.report.evaluations = refined.report.evaluations;
  result.report.end = refined.report.end;

  const bool had_too_many = limits.most_legs && route.drives.size() > *limits.most_legs;
  cost::DrivenRoute moved = on_cheapest_drives(leg, refined.itinerary);
  if (refined.report.end == RefinementEnd::evaluations) {
    // For the case that the budget ended before refinement could remove needless points.
    const double most_cost =
        std::min(before->cost(objective), (1.0 + worth_points) * refined.itinerary.cost());
    moved = cost::drop_cheap_points(sea, moved, objective, cost::at_departure, most_cost, budget.stop);
  }
  const auto after = cost::drive_along(sea, moved, cost::at_departure);
  const double most = (1.0 + limits.tolerance) * before->cost(objective);
  if (after && (had_too_many || after->cost(objective) <= most)) result.route = std::move(moved);
  return result;
}

}  // namespace floeplan::planning::publish

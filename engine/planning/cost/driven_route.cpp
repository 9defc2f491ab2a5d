#include "engine/planning/cost/driven_route.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "engine/planning/cost/hold_times.hpp"
#include "engine/planning/cost/straightening.hpp"

namespace floeplan::planning::cost {
namespace {

/// Removing a point that changes nothing may seem to change the cost by this share: the integral over one leg
/// and those over its two halves differ by a hundredth of their own tolerance.
constexpr double rounding = 1e-6;

/// A route after one point was removed, and its cost.
struct Shorter {
  DrivenRoute route;
  double cost{};
};

std::optional<Shorter> without(const Sea& sea, const DrivenRoute& route, std::size_t i,
                               const Objective& objective, core::Seconds depart) {
  std::optional<Shorter> best;
  const auto at = static_cast<std::ptrdiff_t>(i);
  DrivenRoute shorter = route;
  shorter.points.erase(shorter.points.begin() + at);
  shorter.fixed.erase(shorter.fixed.begin() + at);
  shorter.drives.erase(shorter.drives.begin() + at);
  for (const vehicle::Drive drive : sea.drives()) {
    shorter.drives[i - 1] = drive;
    const auto times = drive_along(sea, shorter, depart);
    if (!times) continue;
    const double cost = times->cost(objective);
    if (!best || cost < best->cost) best = Shorter{shorter, cost};
  }
  return best;
}

/// The route after the removal of the point that costs least; empty if none can be. Fixed points stay.
std::optional<Shorter> without_cheapest(const Sea& sea, const DrivenRoute& route, const Objective& objective,
                                        core::Seconds depart, const std::stop_token& stop) {
  std::optional<Shorter> cheapest;
  for (std::size_t i = 1; i + 1 < route.points.size(); ++i) {
    if (stop.stop_requested()) return std::nullopt;
    if (route.fixed[i]) continue;
    auto shorter = without(sea, route, i, objective, depart);
    if (shorter && (!cheapest || shorter->cost < cheapest->cost)) cheapest = std::move(shorter);
  }
  return cheapest;
}

}  // namespace

tl::expected<DrivenTimes, motion::EdgeClosed> drive_along(const Sea& sea, const DrivenRoute& route,
                                                          core::Seconds depart, core::Seconds since_surfacing,
                                                          Dives dives) {
  DrivenTimes times{.arrivals = {depart}, .energy = {}, .encounters = 0.0};
  for (std::size_t i = 1; i < route.points.size(); ++i) {
    const geo::PlanePoint from = route.points[i - 1];
    const geo::PlanePoint to = route.points[i];
    const vehicle::Drive drive = route.drives[i - 1];
    const core::Seconds leaves = times.arrivals.back();
    const auto driven =
        sea.metered_leg(from, to, leaves, since_surfacing, core::Seconds{INFINITY}, drive, dives);
    if (!driven) return tl::unexpected(driven.error());
    since_surfacing = driven->leg.since_surfacing;
    times.encounters += sea.encounters(from, to, leaves, driven->leg.time);
    times.energy += driven->energy;
    times.arrivals.push_back(leaves + driven->leg.time);
  }
  times.since_surfacing = since_surfacing;
  return times;
}

tl::expected<DrivenTimes, motion::EdgeClosed> drive_in_time(const Sea& sea, const DrivenRoute& route,
                                                            core::Seconds depart) {
  const vehicle::Drive first = sea.drives().front();
  const bool waits = holds_may_help(sea);
  if (!waits || std::ranges::any_of(route.drives, [&](vehicle::Drive drive) { return drive != first; }))
    return drive_along(sea, route, depart);
  const auto schedule = schedule_along(sea, route.points, depart);
  if (!schedule) return tl::unexpected(schedule.error().reason);
  DrivenTimes times{.arrivals = schedule->arrivals, .energy = {}, .encounters = 0.0};
  const auto count = [&](geo::PlanePoint from, geo::PlanePoint to, core::Seconds leaves, core::Seconds time) {
    times.encounters += sea.encounters(from, to, leaves, time);
    times.energy += sea.energy_along(from, to, leaves, time, first);
  };
  for (std::size_t i = 1; i < route.points.size(); ++i) {
    const geo::PlanePoint from = route.points[i - 1];
    count(from, from, schedule->arrivals[i - 1], schedule->waits[i - 1]);
    count(from, route.points[i], schedule->leaves(i - 1), schedule->arrivals[i] - schedule->leaves(i - 1));
  }
  return times;
}

DrivenRoute drop_costless_points(const Sea& sea, const DrivenRoute& route, const Objective& objective,
                                 core::Seconds depart, const std::stop_token& stop) {
  DrivenRoute result = route;
  const auto times = drive_along(sea, result, depart);
  if (!times) return result;
  const double most = times->cost(objective);
  double cost = most;
  bool changed = true;
  while (changed) {
    changed = false;
    for (std::size_t i = 1; i + 1 < result.points.size();) {
      if (stop.stop_requested()) return result;
      auto shorter = result.fixed[i] ? std::nullopt : without(sea, result, i, objective, depart);
      if (shorter && shorter->cost <= std::min(most, cost * (1.0 + rounding))) {
        cost = shorter->cost;
        result = std::move(shorter->route);
        changed = true;
      } else {
        ++i;
      }
    }
  }
  return result;
}

DrivenRoute drop_cheap_points(const Sea& sea, const DrivenRoute& route, const Objective& objective,
                              core::Seconds depart, double most_cost, const std::stop_token& stop) {
  DrivenRoute result = route;
  for (;;) {
    auto shorter = without_cheapest(sea, result, objective, depart, stop);
    if (!shorter || shorter->cost > most_cost) return result;
    result = std::move(shorter->route);
  }
}

DrivenRoute drop_to(const Sea& sea, const DrivenRoute& route, const Objective& objective,
                    core::Seconds depart, std::size_t most, const std::stop_token& stop) {
  DrivenRoute result = route;
  while (result.points.size() > most) {
    auto shorter = without_cheapest(sea, result, objective, depart, stop);
    if (!shorter) return result;
    result = std::move(shorter->route);
  }
  return result;
}

DrivenRoute choose_drives(const Sea& sea, const DrivenRoute& route, const Objective& objective,
                          core::Seconds depart, const std::stop_token& stop) {
  if (sea.drives().size() == 1) return route;
  DrivenRoute best = route;
  const auto times = drive_along(sea, best, depart);
  double cost = times ? times->cost(objective) : INFINITY;
  for (std::size_t leg = 0; leg < route.drives.size(); ++leg) {
    if (stop.stop_requested()) return best;
    for (const vehicle::Drive drive : sea.drives()) {
      DrivenRoute other = best;
      other.drives[leg] = drive;
      const auto other_times = drive_along(sea, other, depart);
      if (!other_times || !(other_times->cost(objective) < cost)) continue;
      cost = other_times->cost(objective);
      best = std::move(other);
    }
  }
  return best;
}

DrivenRoute part_long_legs(const PlanningDomain& domain, const DrivenRoute& route, core::Metres longest) {
  DrivenRoute result{.points = {route.points.front()}, .fixed = {route.fixed.front()}, .drives = {}};
  for (std::size_t i = 1; i < route.points.size(); ++i) {
    const Route leg{{route.points[i - 1], route.points[i]}, {route.fixed[i - 1], route.fixed[i]}};
    const Route parted = part_long_legs(domain, leg, longest);
    for (std::size_t part = 1; part < parted.points.size(); ++part) {
      result.points.push_back(parted.points[part]);
      result.fixed.push_back(parted.fixed[part]);
      result.drives.push_back(route.drives[i - 1]);
    }
  }
  return result;
}

}  // namespace floeplan::planning::cost

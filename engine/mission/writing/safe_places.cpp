#include "engine/mission/writing/safe_places.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include "engine/geo/geodesic.hpp"
#include "engine/messages/export_messages.hpp"
#include "engine/messages/mission_fault_messages.hpp"
#include "engine/mission/writing/argument_lines.hpp"
#include "engine/mission/writing/shoals.hpp"

namespace floeplan::mission {
namespace {

bool is_on_land(const SafePlace& safe, const std::optional<core::Metres>& bed) {
  if (bed && bed->value <= 0.0) return true;
  return std::ranges::any_of(safe.sea.land,
                             [&](const geo::Polygon& land) { return geo::contains(land, safe.place); });
}

struct IceThere {
  double densest{};   // during the plan, as far as known
  bool known{false};  // known all the time
};

/// The concentration at a time: interpolated between the steps around it. At times when one step of the ice
/// is held, it is the concentration of this step.
std::optional<double> concentration_then(const ocean::IceField& product, geo::LonLat place, double time_s) {
  const ocean::Axis& steps_s = product.samples().times_s;
  const ocean::IceMoment when = ocean::ice_moment(steps_s.nodes(), time_s);
  if (!when.is_known()) return std::nullopt;
  const auto first = product.at(place, core::from_unix_seconds(steps_s[when.first]));
  const auto second = product.at(place, core::from_unix_seconds(steps_s[when.second]));
  if (!first || (!second && when.share > 0.0)) return std::nullopt;
  if (when.share == 0.0) return first->concentration;
  return first->concentration + when.share * (second->concentration - first->concentration);
}

/// Whether two steps are so far apart that the ice is unknown for some time in this period.
bool has_wide_gap(const std::vector<double>& steps_s, double from_s, double until_s) {
  const double hold_s = ocean::longest_ice_hold.count();
  const auto gap = std::ranges::adjacent_find(steps_s, [&](double before_s, double after_s) {
    return after_s - before_s > ocean::longest_ice_gap.count() && before_s + hold_s < until_s &&
           after_s - hold_s > from_s;
  });
  return gap != steps_s.end();
}

IceThere ice_of(const ocean::IceField& product, const planning::Plan& plan, geo::LonLat place) {
  const std::vector<double>& steps_s = product.samples().times_s.nodes();
  const double from_s = core::unix_seconds(plan.departure);
  const double until_s = core::unix_seconds(plan.arrival);
  std::vector<double> times_s{from_s, until_s};  // ice is linear between steps, or held
  for (const double step_s : steps_s)
    if (step_s > from_s && step_s < until_s) times_s.push_back(step_s);

  IceThere found{.known = !has_wide_gap(steps_s, from_s, until_s)};
  for (const double time_s : times_s) {
    const auto ice = concentration_then(product, place, time_s);
    found.known = found.known && ice.has_value();
    if (ice) found.densest = std::max(found.densest, *ice);
  }
  return found;
}

/// The densest ice of all products at the place.
IceThere ice_at(const planning::Plan& plan, const SafePlace& safe) {
  if (!safe.sea.ice) return {};
  IceThere found = ice_of(*safe.sea.ice, plan, safe.place);
  for (const auto& product : safe.sea.further_ice) {
    const IceThere there = ice_of(*product, plan, safe.place);
    found = {.densest = std::max(found.densest, there.densest), .known = found.known || there.known};
  }
  return found;
}

/// Whether the battery suffices to reach the place from some waypoint; true if the plan has no energy.
bool is_within_battery(const planning::Plan& plan, const vehicle::GliderProfile& vehicle, geo::LonLat place) {
  const double power_w = plan.energy ? plan.energy->use.total().value / plan.travel_time().count() : 0.0;
  if (!(power_w > 0.0)) return true;  // not known
  return std::ranges::any_of(plan.waypoints, [&](const planning::Waypoint& waypoint) {
    const double left_j = plan.energy->usable.value - waypoint.energy.value_or(core::Joules{0.0}).value;
    const double range_m = vehicle.speed_through_water.value * left_j / power_w;
    return geo::geodesic_between(waypoint.place, place).length.value <= range_m;
  });
}

double distance_km(const planning::Plan& plan, geo::LonLat place) {
  double least_m = std::numeric_limits<double>::infinity();
  for (const planning::Waypoint& waypoint : plan.waypoints)
    least_m = std::min(least_m, geo::geodesic_between(waypoint.place, place).length.value);
  return least_m / 1000.0;
}

/// A no-go area around the place that is in force at some time after the departure; null: none.
const ocean::Zone* zone_round(const planning::Plan& plan, const SafePlace& safe) {
  const auto found = std::ranges::find_if(safe.sea.zones, [&](const ocean::Zone& zone) {
    const bool is_over = zone.until && *zone.until < plan.departure;
    return zone.kind == ocean::ZoneKind::no_go && !is_over && geo::contains(zone.area, safe.place);
  });
  return found == safe.sea.zones.end() ? nullptr : &*found;
}

core::Metres away(const ocean::Iceberg& berg, geo::LonLat place) {
  return geo::geodesic_between(berg.place, place).length;
}

bool covers(const ocean::Iceberg& berg, geo::LonLat place) {
  return away(berg, place).value <= 0.5 * ocean::safe_length(berg).value;
}

/// The reason to refuse the place; empty: none.
std::optional<core::Violation> fault_of(const planning::Plan& plan, const vehicle::GliderProfile& vehicle,
                                        double max_concentration, const SafePlace& safe,
                                        const std::optional<core::Metres>& bed, const IceThere& ice,
                                        const std::string& field) {
  const std::string place = place_text(safe.place);
  if (is_on_land(safe, bed)) return messages::mission_fault<"safe-place-on-land">(field, place);
  if (bed && *bed < vehicle.least_water())
    return messages::mission_fault<"safe-place-too-shallow">(field, place, std::floor(bed->value),
                                                             std::ceil(vehicle.least_water().value));
  if (ice.densest > max_concentration)
    return messages::mission_fault<"safe-place-in-ice">(field, place, std::round(100.0 * ice.densest),
                                                        std::round(100.0 * max_concentration));
  if (const ocean::Zone* zone = zone_round(plan, safe))
    return messages::mission_fault<"safe-place-in-zone">(field, place, zone->name);
  for (const ocean::Iceberg& berg : safe.sea.icebergs)
    if (covers(berg, safe.place))
      return messages::mission_fault<"safe-place-at-iceberg">(field, place, berg.id);
  if (!is_within_battery(plan, vehicle, safe.place))
    return messages::mission_fault<"safe-place-too-far">(field, place, distance_km(plan, safe.place));
  return std::nullopt;
}

}  // namespace

SafePlaceFindings check_safe_places(const planning::Plan& plan, const vehicle::GliderProfile& vehicle,
                                    double max_concentration_to_surface,
                                    const std::vector<SafePlace>& places) {
  SafePlaceFindings found;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const SafePlace& safe = places[i];
    if (!geo::is_valid(safe.place)) throw std::invalid_argument{"check_safe_places: a place off the Earth"};
    std::optional<core::Metres> bed;
    if (safe.sea.bathymetry) bed = safe.sea.bathymetry->shoalest(safe.place);
    const IceThere ice = ice_at(plan, safe);
    if (auto fault = fault_of(plan, vehicle, max_concentration_to_surface, safe, bed, ice,
                              "/safe/" + std::to_string(i))) {
      found.violations.push_back(std::move(*fault));
      continue;
    }
    for (const ocean::Iceberg& berg : safe.sea.icebergs) {
      found.messages.push_back(
          messages::export_message<"iceberg-near-safe-place">(
              berg.id, away(berg, safe.place).value / 1000.0, place_text(safe.place))
              .at(safe.place));
    }
    if (bed && ice.known) continue;
    const std::string unknown = !bed && !ice.known ? "the sea bed and the ice"
                                : !bed             ? "the sea bed"
                                                   : "the ice";
    found.messages.push_back(
        messages::export_message<"safe-place-unknown">(unknown, place_text(safe.place)).at(safe.place));
  }
  return found;
}

}  // namespace floeplan::mission

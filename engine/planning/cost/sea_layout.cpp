#include "engine/planning/cost/sea_layout.hpp"

#include <algorithm>
#include <cmath>

#include "engine/geo/geodesic.hpp"

namespace floeplan::planning::cost {
namespace {

constexpr core::Seconds day{86'400.0};

/// The International Ice Patrol drops a berg from its list when it was not seen for this time.
constexpr core::Seconds longest_drift = 30.0 * day;

/// The last time at which the request allows a departure.
core::UtcTime last_departure(const PlanRequest& request) {
  const DepartureRules& rules = request.departures;
  return std::max(
      {request.depart, rules.until.value_or(request.depart), rules.arrive_by.value_or(request.depart)});
}

/// Whether the stored ice is anywhere, at any time, too dense to surface in.
bool has_dense_ice(const ocean::Environment& environment, const UnderIceRules& rules) {
  const auto is_dense = [&](const std::shared_ptr<const ocean::IceField>& ice) {
    return ice && std::ranges::any_of(ice->samples().concentration, [&](float concentration) {
             return static_cast<double>(concentration) > rules.max_concentration_to_surface;
           });
  };
  return is_dense(environment.ice) || std::ranges::any_of(environment.further_ice, is_dense);
}

std::optional<obstacles::PassUnder> lay_out_under(const PlanRequest& request,
                                                  std::shared_ptr<const obstacles::BedCells> bed) {
  if (!request.icebergs.pass_under) return std::nullopt;
  return obstacles::PassUnder{request.icebergs, request.vehicle, std::move(bed)};
}

/// Extra distance in a search from the edges of icebergs and zones. The route is checked again from written
/// positions, in another plane, and must stay clear there. Mission files round to 1/10000 minute, 0.19 m.
core::Metres kept_for_rounding(const PlanRequest& request) {
  return core::Metres{request.method == Method::direct ? 0.0 : 0.3};
}

/// The places where the vehicle surfaces on every route. The inner points of a given route are only turns:
/// the vehicle may pass them below icebergs.
std::vector<geo::PlanePoint> stops_in_plane(const PlanRequest& request,
                                            const geo::LocalProjection& projection) {
  std::vector<geo::PlanePoint> stops{projection.to_plane(request.from), projection.to_plane(request.to)};
  if (request.method == Method::direct) return stops;
  for (const geo::LonLat via : request.via) stops.push_back(projection.to_plane(via));
  return stops;
}

}  // namespace

core::Seconds forecast_horizon(const ocean::Environment& environment, const PlanRequest& request) {
  const core::UtcTime last = last_departure(request);
  core::Seconds under_way = drift_for_the_way(request);
  if (environment.currents && !environment.steady_currents) {
    const core::UtcTime end = core::from_unix_seconds(environment.currents->times_s().back());
    under_way = std::max<core::Seconds>(under_way, end - last);
  }
  return (last - request.depart) + std::min(under_way, longest_drift);
}

bool passes_below(const ocean::Environment& environment, const PlanRequest& request) {
  return request.icebergs.pass_under || has_dense_ice(environment, request.under_ice);
}

core::Seconds drift_for_the_way(const PlanRequest& request) {
  constexpr double detours = 6.0;
  // With holds a route may take any time.
  if (request.holds.longest.count() > 0.0) return longest_drift;
  core::Metres way{0.0};
  geo::LonLat last = request.from;
  for (const geo::LonLat via : request.via) {
    way = way + geo::geodesic_between(last, via).length;
    last = via;
  }
  way = way + geo::geodesic_between(last, request.to).length;
  if (request.room) way = way + *request.room;
  const core::Seconds longest = detours * (way / request.vehicle.speed_through_water) + day;
  return std::ceil(longest / day) * day;
}

/// Zones count from the surface down to the dive depth, because a glider surfaces between its dives.
obstacles::ZoneRules lay_out_zones(const ocean::Environment& environment, const PlanRequest& request) {
  std::vector<ocean::Zone> zones = environment.zones;
  zones.insert(zones.end(), request.zones.begin(), request.zones.end());
  return obstacles::sort_zones(zones, {core::Metres{0.0}, request.vehicle.dive_depth});
}

obstacles::TimedZones lay_out_timed_zones(const std::vector<ocean::Zone>& timed, const PlanRequest& request,
                                          const geo::LocalProjection& projection,
                                          const plane::PlaneBox& area) {
  if (request.method == Method::direct) return {timed, projection, area, request.depart};
  // Arrival times of one route in two planes agree to a few parts in a million. This share also covers the
  // rounding of positions.
  constexpr double of_the_way = 1e-5;
  constexpr core::Seconds of_rounding{1.0};
  constexpr core::Seconds most{60.0};
  const core::Seconds time = std::min(most, of_rounding + of_the_way * drift_for_the_way(request));
  return {timed, projection, area, request.depart, obstacles::Room{kept_for_rounding(request), time}};
}

std::shared_ptr<const obstacles::BedCells> lay_out_bed_below(const ocean::Environment& environment,
                                                             const PlanRequest& request,
                                                             const geo::LocalProjection& projection,
                                                             const plane::PlaneBox& area, core::Metres cell,
                                                             const std::stop_token& stop) {
  if (!passes_below(environment, request) || !environment.bathymetry) return nullptr;
  return obstacles::lay_out_bed(environment.bathymetry, request.vehicle, projection, area, cell, stop);
}

obstacles::IcebergDiscs lay_out_icebergs(const ocean::Environment& environment, const PlanRequest& request,
                                         const geo::LocalProjection& projection, const plane::PlaneBox& area,
                                         std::shared_ptr<const obstacles::BedCells> bed,
                                         const std::stop_token& stop) {
  return {environment,
          request.icebergs,
          projection,
          area,
          request.depart,
          forecast_horizon(environment, request),
          stop,
          lay_out_under(request, std::move(bed)),
          stops_in_plane(request, projection),
          kept_for_rounding(request)};
}

std::shared_ptr<const currents::PlaneCurrents> lay_out_currents(
    const ocean::Environment& environment, const PlanRequest& request, const currents::FlownDepths& depths,
    const ice::UnderIce* ice, const geo::LocalProjection& projection, const plane::PlaneBox& area,
    const std::stop_token& stop) {
  if (!environment.currents) return nullptr;
  return std::make_shared<const currents::PlaneCurrents>(*environment.currents, environment.steady_currents,
                                                         depths, projection, area, request.depart, stop, ice);
}

std::optional<ice::UnderIce> lay_out_ice(const ocean::Environment& environment, const PlanRequest& request,
                                         const geo::LocalProjection& projection, const plane::PlaneBox& area,
                                         core::Metres cell, std::shared_ptr<const obstacles::BedCells> bed,
                                         const std::stop_token& stop) {
  if (!environment.ice) return std::nullopt;
  return ice::UnderIce{environment, request, projection, area, cell, std::move(bed), stop};
}

std::optional<obstacles::EncounterMap> lay_out_encounters(const obstacles::IcebergDiscs& icebergs,
                                                          const ocean::Environment& environment,
                                                          const PlanRequest& request,
                                                          const plane::PlaneBox& area,
                                                          const std::stop_token& stop) {
  if (request.icebergs.encounter_weight.count() <= 0.0 || icebergs.empty()) return std::nullopt;
  return obstacles::EncounterMap{
      icebergs, area, forecast_horizon(environment, request),
      drive_speed(request.vehicle, drives(request.energy, request.vehicle).front()), stop};
}

}  // namespace floeplan::planning::cost

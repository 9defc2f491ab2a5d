#include "engine/planning/cost/sea_shelf.hpp"

#include <utility>

#include "engine/planning/cost/sea_layout.hpp"

namespace floeplan::planning::cost {

std::shared_ptr<const obstacles::BedCells> SeaShelf::bed_below(const ocean::Environment& environment,
                                                               const PlanRequest& request,
                                                               const geo::LocalProjection& projection,
                                                               const plane::PlaneBox& area, core::Metres cell,
                                                               const std::stop_token& stop) {
  const BedKey key{.bathymetry = environment.bathymetry,
                   .is_passed_below = passes_below(environment, request),
                   .vehicle = request.vehicle,
                   .site = {projection.origin(), area},
                   .cell = cell};
  return beds_.take(key, stop,
                    [&] { return lay_out_bed_below(environment, request, projection, area, cell, stop); });
}

std::shared_ptr<const obstacles::IcebergDiscs> SeaShelf::icebergs(
    const ocean::Environment& environment, const PlanRequest& request, const geo::LocalProjection& projection,
    const plane::PlaneBox& area, std::shared_ptr<const obstacles::BedCells> bed,
    const std::stop_token& stop) {
  const auto make = [&] {
    return std::make_shared<const obstacles::IcebergDiscs>(
        lay_out_icebergs(environment, request, projection, area, std::move(bed), stop));
  };
  if (request.icebergs.pass_under) return make();
  const IcebergsKey key{
      .icebergs = environment.icebergs,
      .carrying = environment.drift_currents ? environment.drift_currents : environment.currents,
      .steady = environment.steady_currents,
      .wind = environment.wind,
      .bathymetry = environment.bathymetry,
      .rules = request.icebergs,
      .site = {projection.origin(), area},
      .epoch = request.depart,
      .horizon = forecast_horizon(environment, request),
      .is_direct = request.method == Method::direct};
  return icebergs_.take(key, stop, make);
}

SeaShelf::CurrentsKey SeaShelf::currents_key(const ocean::Environment& environment,
                                             const PlanRequest& request,
                                             const geo::LocalProjection& projection,
                                             const plane::PlaneBox& area) {
  CurrentsKey key{.currents = environment.currents,
                  .steady = environment.steady_currents,
                  .bathymetry = environment.bathymetry,
                  .site = {projection.origin(), area},
                  .epoch = request.depart,
                  .limits = request.vehicle.dive_limits(),
                  .below_ice = {}};
  if (environment.ice) {
    key.below_ice = {.ice = environment.ice,
                     .further_ice = environment.further_ice,
                     .max_concentration_to_surface = request.under_ice.max_concentration_to_surface,
                     .margin = request.under_ice.margin_below_ice,
                     .draft_if_unknown = request.under_ice.draft_if_unknown};
  }
  return key;
}

bool SeaShelf::holds_currents(const ocean::Environment& environment, const PlanRequest& request,
                              const geo::LocalProjection& projection, const plane::PlaneBox& area) const {
  return currents_.holds(currents_key(environment, request, projection, area));
}

std::shared_ptr<const currents::PlaneCurrents> SeaShelf::currents(
    const ocean::Environment& environment, const PlanRequest& request, const currents::FlownDepths& depths,
    const ice::UnderIce* ice, const geo::LocalProjection& projection, const plane::PlaneBox& area,
    const std::stop_token& stop) {
  const auto make = [&] {
    return lay_out_currents(environment, request, depths, ice, projection, area, stop);
  };
  // Drawn for one member: nobody asks for them again, and many members fill the memory.
  if (environment.currents && environment.currents->added()) return make();
  return currents_.take(currents_key(environment, request, projection, area), stop, make);
}

}  // namespace floeplan::planning::cost

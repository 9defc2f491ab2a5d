#include "engine/planning/energy/energy_map.hpp"

#include <algorithm>
#include <cmath>

namespace floeplan::planning::energy {
namespace {

constexpr double most_cells_a_side = 256.0;
constexpr core::Metres least_look{
    1.0};  // distance between samples along a line; smaller cells of a bathymetry are not resolved
constexpr double looks_in_cell[] = {0.25, 0.75};  // sample positions in a raster cell, along either axis

/// Cell size of the raster. Without bathymetry one cell covers the area.
core::Metres cell_of(const currents::FlownDepths& depths, const plane::PlaneBox& area) {
  const double extent_m = std::max(area.width_m(), area.height_m());
  if (!depths.bathymetry()) return {extent_m};
  return {std::max(extent_m / most_cells_a_side, depths.bathymetry()->grid().spacing().value)};
}

/// Pump energy per metre of depth climbed or dived.
double pump_j_m(const vehicle::EnergyModel& model, core::CubicMetres buoyancy,
                const vehicle::DiveBand& band) {
  constexpr core::MetresPerSecond metre_a_second{1.0};
  return vehicle::pump_power(model, buoyancy, band, metre_a_second).value;
}

}  // namespace

EnergyMap::EnergyMap(const vehicle::GliderProfile& profile, const currents::FlownDepths& depths,
                     const geo::LocalProjection& projection, const plane::PlaneBox& area,
                     const std::stop_token& stop)
    : model_{profile.energy},
      buoyancy_volume_{profile.buoyancy},
      limits_{depths.limits()},
      raster_{area, cell_of(depths, area)},
      // The deeper the band, the less energy the pump needs per metre: the fixed costs of a turn matter less.
      least_pump_j_m_{
          pump_j_m(profile.energy, profile.buoyancy, vehicle::flown_band(depths.limits(), std::nullopt))},
      buoyancy_{.vertical = profile.vertical_speed(profile.speed_through_water),
                .power = vehicle::steady_power(profile.energy),
                .thruster = {}},
      thruster_{buoyancy_} {
  if (profile.thruster) {
    thruster_.vertical = profile.vertical_speed(profile.thruster->speed);
    thruster_.thruster = profile.thruster->power;
  }
  if (depths.bathymetry()) {
    bed_.emplace(depths.bathymetry(), projection, area, stop);
    look_ = std::max(depths.bathymetry()->grid().spacing(), least_look);
    is_even_ = bed_->least_depth() >= limits_.dive_to + limits_.altimeter_margin;
  }
  places_.reserve(raster_.size());
  for (std::int64_t iy = 0; iy < raster_.ny(); ++iy) {
    if (stop.stop_requested()) return;
    for (std::int64_t ix = 0; ix < raster_.nx(); ++ix) {
      places_.push_back(place_of_cell(ix, iy));
    }
  }
}

EnergyMap::Place EnergyMap::place_of_cell(std::int64_t ix, std::int64_t iy) const {
  const vehicle::DiveBand deepest = vehicle::flown_band(limits_, std::nullopt);
  double turns_m = 1.0 / deepest.thickness().value;
  if (bed_) {
    turns_m = 0.0;
    for (const double fy : looks_in_cell) {
      for (const double fx : looks_in_cell) {
        const geo::PlanePoint here{
            raster_.area().low.x_m + (static_cast<double>(ix) + fx) * raster_.cell_m(),
            raster_.area().low.y_m + (static_cast<double>(iy) + fy) * raster_.cell_m()};
        turns_m += 0.25 / vehicle::flown_band(limits_, bed_->depth(here)).thickness().value;
      }
    }
  }
  const vehicle::DiveBand mean{deepest.top, deepest.top + core::Metres{1.0 / turns_m}};
  return {static_cast<float>(pump_j_m(model_, buoyancy_volume_, mean)), static_cast<float>(turns_m),
          static_cast<float>(mean.top.value), static_cast<float>(mean.bottom.value)};
}

const EnergyMap::Place& EnergyMap::place(std::int64_t ix, std::int64_t iy) const {
  return places_[raster_.index(std::clamp<std::int64_t>(ix, 0, raster_.nx() - 1),
                               std::clamp<std::int64_t>(iy, 0, raster_.ny() - 1))];
}

bool EnergyMap::is_even_along(geo::PlanePoint a, geo::PlanePoint b) const {
  if (is_even_) return true;
  const Place* first = nullptr;
  bool even = true;
  raster_.for_each_cell(a, b, [&](std::int64_t ix, std::int64_t iy) {
    const Place& here = place(ix, iy);
    if (first == nullptr) first = &here;
    even = here.pump_j_m == first->pump_j_m && here.inflections_m == first->inflections_m;
    return even;
  });
  return even;
}

EnergyMap::Place EnergyMap::below(const Place& place, core::Metres upper_turn) const {
  if (upper_turn.value <= static_cast<double>(place.top_m)) return place;
  const vehicle::DiveBand band = vehicle::band_below(
      upper_turn,
      {core::Metres{static_cast<double>(place.top_m)}, core::Metres{static_cast<double>(place.bottom_m)}});
  return {static_cast<float>(pump_j_m(model_, buoyancy_volume_, band)),
          static_cast<float>(1.0 / band.thickness().value), static_cast<float>(band.top.value),
          place.bottom_m};
}

EnergyUse EnergyMap::use(geo::PlanePoint a, geo::PlanePoint b, core::Seconds time, vehicle::Drive drive,
                         core::Metres upper_turn) const {
  double pump_j_m = 0.0;
  double inflections_m = 0.0;
  double from = 0.0;
  raster_.for_each_stretch(a, b, [&](std::int64_t ix, std::int64_t iy, double until) {
    const Place here = below(place(ix, iy), upper_turn);
    const double share = is_even_ ? 1.0 : until - from;
    pump_j_m += share * static_cast<double>(here.pump_j_m);
    inflections_m += share * static_cast<double>(here.inflections_m);
    from = until;
    return !is_even_;
  });
  return drawn(pump_j_m, inflections_m, time, drive);
}

EnergyUse EnergyMap::use(const vehicle::DiveBand& band, core::Seconds time, vehicle::Drive drive) const {
  return drawn(pump_j_m(model_, buoyancy_volume_, band), 1.0 / band.thickness().value, time, drive);
}

EnergyUse EnergyMap::drawn(double pump_j_m, double inflections_m, core::Seconds time,
                           vehicle::Drive drive) const {
  const DriveCost& drive_cost = cost(drive);
  const double depth_changed_m = drive_cost.vertical.value * time.count();
  return {.hotel = drive_cost.power * time,
          .pump = {pump_j_m * depth_changed_m},
          .thruster = drive_cost.thruster * time,
          .inflections = inflections_m * depth_changed_m};
}

DiveLine EnergyMap::dives_along(geo::PlanePoint a, geo::PlanePoint b) const {
  return {limits_, bed_ && !is_even_ ? &*bed_ : nullptr, look_, a, b};
}

core::Watts EnergyMap::least_power(vehicle::Drive drive) const {
  const DriveCost& drive_cost = cost(drive);
  // Slightly lower, because the costs of places are stored as floats.
  return {drive_cost.power.value + drive_cost.thruster.value +
          (1.0 - 1e-6) * least_pump_j_m_ * drive_cost.vertical.value};
}

}  // namespace floeplan::planning::energy

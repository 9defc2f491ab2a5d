#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <stop_token>
#include <vector>

#include "engine/planning/currents/flown_depths.hpp"
#include "engine/planning/energy/dive_line.hpp"
#include "engine/planning/obstacles/plane_bed.hpp"
#include "engine/planning/plane/plane_raster.hpp"
#include "engine/planning/problem/energy_use.hpp"
#include "engine/vehicle/drive.hpp"
#include "engine/vehicle/glider_profile.hpp"

namespace floeplan::planning::energy {

/// The power that a glider needs at each place: over a shallow bank it turns more often, in deep water it
/// pumps against more pressure. There are two ways to ask. `dives_along` uses the sea bed itself, and does
/// not depend on the area of the map. `use` between two points uses a raster of the sea bed; searches need
/// it, because they ask very often.
/// Accuracy  of the raster: cells no smaller than those of the bathymetry, at most 256 a side; along a line
///           exact
/// Threads   const members may be called from several threads at once
class EnergyMap {
 public:
  /// Once `stop` is requested the map stays incomplete and must not be used.
  EnergyMap(const vehicle::GliderProfile& profile, const currents::FlownDepths& depths,
            const geo::LocalProjection& projection, const plane::PlaneBox& area, const std::stop_token& stop);

  /// The energy of a straight move from a to b at constant speed in this time, from the raster. A drive in
  /// currents consists of many such moves.
  /// `upper_turn`: no dive turns above it. If that leaves no room, the smallest saw-tooth above the
  /// lower turn counts.
  [[nodiscard]] EnergyUse use(geo::PlanePoint a, geo::PlanePoint b, core::Seconds time, vehicle::Drive drive,
                              core::Metres upper_turn = {}) const;
  /// The energy of a move in `time` with dives in this band.
  [[nodiscard]] EnergyUse use(const vehicle::DiveBand& band, core::Seconds time, vehicle::Drive drive) const;
  /// The dives over the sea bed itself from a to b.
  [[nodiscard]] DiveLine dives_along(geo::PlanePoint a, geo::PlanePoint b) const;
  /// The distance between samples of the sea bed along a line; infinite where no bed is known.
  [[nodiscard]] core::Metres look() const { return look_; }
  /// The least power of any place.
  [[nodiscard]] core::Watts least_power(vehicle::Drive drive) const;
  /// Whether every place costs the same, so that energy is power times time.
  [[nodiscard]] bool is_even() const { return is_even_; }
  /// Whether all places of the raster on a line have the same power.
  [[nodiscard]] bool is_even_along(geo::PlanePoint a, geo::PlanePoint b) const;
  /// The size of the raster's cells.
  [[nodiscard]] core::Metres cell() const { return core::Metres{raster_.cell_m()}; }

  [[nodiscard]] std::size_t bytes() const { return places_.size() * sizeof(Place); }

 private:
  struct Place {
    float pump_j_m;       // per metre of depth climbed or dived
    float inflections_m;  // inflections per metre of depth climbed or dived
    float top_m;
    float bottom_m;
  };
  struct DriveCost {
    core::MetresPerSecond vertical;
    core::Watts power;  // power of everything but the pump
    core::Watts thruster;
  };
  /// The place for a cell: a band with the mean number of turns of the samples in the cell.
  [[nodiscard]] Place place_of_cell(std::int64_t ix, std::int64_t iy) const;
  /// The place of a cell. Beyond the raster, the place of the nearest cell.
  [[nodiscard]] const Place& place(std::int64_t ix, std::int64_t iy) const;
  /// A copy of the place whose dives turn no higher than `upper_turn`.
  [[nodiscard]] Place below(const Place& place, core::Metres upper_turn) const;
  [[nodiscard]] const DriveCost& cost(vehicle::Drive drive) const {
    return drive == vehicle::Drive::thruster ? thruster_ : buoyancy_;
  }

  /// The energy of dives with these values per metre of depth.
  [[nodiscard]] EnergyUse drawn(double pump_j_m, double inflections_m, core::Seconds time,
                                vehicle::Drive drive) const;

  vehicle::EnergyModel model_;
  core::CubicMetres buoyancy_volume_;
  vehicle::DiveLimits limits_;
  std::optional<obstacles::PlaneBed> bed_;  // empty: deep water everywhere
  core::Metres look_{INFINITY};
  plane::PlaneRaster raster_;
  std::vector<Place> places_;  // [y][x]
  double least_pump_j_m_;
  bool is_even_{true};
  DriveCost buoyancy_;
  DriveCost thruster_;  // equal to that of the buoyancy engine if there is no thruster
};

}  // namespace floeplan::planning::energy

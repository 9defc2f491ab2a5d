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

/// What a glider draws where: over a shallow bank it turns oftener, in deep water it pumps against more
/// pressure. By the sea bed itself, which says the same of a way whatever area is laid out around it; or by a raster of
/// it, for searches, which ask too often for more.
/// Accuracy  of the raster: cells no smaller than those of the bathymetry, at most 256 a side; along a line exact
/// Threads   const members may be called from several threads at once
class EnergyMap {
 public:
  /// Once `stop` is requested the map stays incomplete and must not be used.
  EnergyMap(const vehicle::GliderProfile& profile, const currents::FlownDepths& depths,
            const geo::LocalProjection& projection, const plane::PlaneBox& area, const std::stop_token& stop);

  /// By the raster, of the straight and even move from a to b in this time; a drive in currents is none, but many of
  /// them.
  /// `upper_turn`: no dive turns above it; where that leaves less than the lowest saw-tooth, as in that.
  [[nodiscard]] EnergyUse use(geo::PlanePoint a, geo::PlanePoint b, core::Seconds time, vehicle::Drive drive,
                              core::Metres upper_turn = {}) const;
  /// Of a move over ground where the vehicle turns as often as in this band.
  [[nodiscard]] EnergyUse use(const vehicle::DiveBand& band, core::Seconds time, vehicle::Drive drive) const;
  /// The dives over the sea bed itself from a to b.
  [[nodiscard]] DiveLine dives_along(geo::PlanePoint a, geo::PlanePoint b) const;
  /// How far apart the looks at the sea bed are along a line; infinite where none is known.
  [[nodiscard]] core::Metres look() const { return look_; }
  /// No place costs less.
  [[nodiscard]] core::Watts least_power(vehicle::Drive drive) const;
  /// Whether every place costs the same, so that energy is power times time.
  [[nodiscard]] bool is_even() const { return is_even_; }
  /// The same for the raster's places on a line.
  [[nodiscard]] bool is_even_along(geo::PlanePoint a, geo::PlanePoint b) const;
  /// How large the raster's places are that are told apart.
  [[nodiscard]] core::Metres cell() const { return core::Metres{raster_.cell_m()}; }

  [[nodiscard]] std::size_t bytes() const { return places_.size() * sizeof(Place); }

 private:
  struct Place {
    float pump_j_m;       // for each metre of depth climbed or dived
    float inflections_m;  // likewise
    float top_m;
    float bottom_m;
  };
  struct DriveCost {
    core::MetresPerSecond vertical;
    core::Watts power;  // besides the pump
    core::Watts thruster;
  };
  /// The mean of what is looked at in a cell: of a band as thick as that of its mean turns.
  [[nodiscard]] Place place_of_cell(std::int64_t ix, std::int64_t iy) const;
  /// Of a cell; beyond the raster that of the nearest one in it.
  [[nodiscard]] const Place& place(std::int64_t ix, std::int64_t iy) const;
  /// The place where the dives turn no higher.
  [[nodiscard]] Place below(const Place& place, core::Metres upper_turn) const;
  [[nodiscard]] const DriveCost& cost(vehicle::Drive drive) const {
    return drive == vehicle::Drive::thruster ? thruster_ : buoyancy_;
  }

  /// Of dives that pump so much and turn so often for each metre of depth.
  [[nodiscard]] EnergyUse drawn(double pump_j_m, double inflections_m, core::Seconds time,
                                vehicle::Drive drive) const;

  vehicle::EnergyModel model_;
  core::CubicMetres buoyancy_volume_;
  vehicle::DiveLimits limits_;
  std::optional<obstacles::PlaneBed> bed_;  // empty: every place is as deep as asked
  core::Metres look_{INFINITY};
  plane::PlaneRaster raster_;
  std::vector<Place> places_;  // [y][x]
  double least_pump_j_m_;
  bool is_even_{true};
  DriveCost buoyancy_;
  DriveCost thruster_;  // as the buoyancy drive where there is none
};

}  // namespace floeplan::planning::energy

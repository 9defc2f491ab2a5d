#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <stop_token>

#include "engine/geo/local_projection.hpp"
#include "engine/ocean/environment.hpp"
#include "engine/planning/cost/overhead.hpp"
#include "engine/planning/cost/sea_shelf.hpp"
#include "engine/planning/currents/flown_depths.hpp"
#include "engine/planning/currents/plane_currents.hpp"
#include "engine/planning/ice/under_ice.hpp"
#include "engine/planning/obstacles/closures.hpp"
#include "engine/planning/obstacles/iceberg_discs.hpp"
#include "engine/planning/obstacles/safety_map.hpp"
#include "engine/planning/obstacles/timed_zones.hpp"
#include "engine/planning/obstacles/zone_rules.hpp"
#include "engine/planning/plane/ground_lengths.hpp"
#include "engine/planning/problem/plan_request.hpp"

namespace floeplan::planning::cost {

/// Where and when the vehicle of one request may be, and what it meets there: water and land, zones,
/// icebergs, sea ice and currents, each on a grid of the local plane. Times count from the departure of the
/// request.
/// Threads  const members may be called from several threads at once
class PlanningDomain {
 public:
  /// `cell`: step of the safety map. If `stop` is requested, the object stays incomplete and must not be
  /// used. `environment` and `request` are borrowed and must outlive the object.
  /// `shelf`: cache of gridded parts, or null; needed only during construction.
  PlanningDomain(const ocean::Environment& environment, const PlanRequest& request,
                 const geo::LocalProjection& projection, const plane::PlaneBox& area, core::Metres cell,
                 const std::stop_token& stop, SeaShelf* shelf);

  [[nodiscard]] const geo::LocalProjection& projection() const { return projection_; }
  /// Lengths on the ground of lines of the plane.
  [[nodiscard]] const plane::GroundLengths& lengths() const { return lengths_; }
  /// The closures of places and their times. The result refers to this domain and must not outlive it.
  [[nodiscard]] obstacles::Closures closures() const { return {safety_, timed_zones_, icebergs()}; }
  [[nodiscard]] const obstacles::SafetyMap& safety() const { return safety_; }
  [[nodiscard]] obstacles::SafetyMap& safety() { return safety_; }
  /// Ice and icebergs above the vehicle.
  [[nodiscard]] const Overhead& overhead() const { return overhead_; }
  [[nodiscard]] const obstacles::IcebergDiscs& icebergs() const { return overhead_.icebergs(); }
  [[nodiscard]] const std::optional<ice::UnderIce>& ice() const { return overhead_.ice(); }
  /// The currents of the domain; null in still water.
  [[nodiscard]] const currents::PlaneCurrents* currents() const { return currents_.get(); }
  /// Whether the currents at the point are known from `from` to the end of the data, sampled at equal
  /// intervals of time. True in still water.
  [[nodiscard]] bool currents_known_to_end(geo::PlanePoint point, core::Seconds from) const;
  /// The depths that the vehicle flies.
  [[nodiscard]] const currents::FlownDepths& depths() const { return depths_; }
  /// Whether nothing in the domain changes with time, so that the time of travel does not matter.
  [[nodiscard]] bool is_steady() const;

  /// From now on the time without surfacing has no limit.
  void lift_bound_on_surfacing() { overhead_.lift_bound_on_surfacing(); }

  /// Memory of the grids, without their sources.
  [[nodiscard]] std::size_t bytes() const;

 private:
  PlanningDomain(const ocean::Environment& environment, const PlanRequest& request,
                 obstacles::ZoneRules zones, const geo::LocalProjection& projection,
                 const plane::PlaneBox& area, core::Metres cell, const std::stop_token& stop,
                 SeaShelf& shelf);

  geo::LocalProjection projection_;
  plane::GroundLengths lengths_;
  std::shared_ptr<const obstacles::BedCells> bed_;  // null: nothing is passed below, or no depth is known
  obstacles::SafetyMap safety_;
  obstacles::TimedZones timed_zones_;
  Overhead overhead_;
  currents::FlownDepths depths_;
  std::shared_ptr<const currents::PlaneCurrents>
      currents_;  // null: still water; domains with the same grids share it
};

}  // namespace floeplan::planning::cost

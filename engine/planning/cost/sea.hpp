#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>
#include <tl/expected.hpp>
#include <vector>

#include "engine/motion/edge_time.hpp"
#include "engine/ocean/environment.hpp"
#include "engine/planning/cost/currents_shelf.hpp"
#include "engine/planning/cost/energy_meter.hpp"
#include "engine/planning/cost/overhead.hpp"
#include "engine/planning/currents/current_envelope.hpp"
#include "engine/planning/currents/flown_depths.hpp"
#include "engine/planning/currents/plane_currents.hpp"
#include "engine/planning/energy/energy_map.hpp"
#include "engine/planning/ice/under_ice.hpp"
#include "engine/planning/obstacles/encounter_map.hpp"
#include "engine/planning/obstacles/iceberg_discs.hpp"
#include "engine/planning/obstacles/safety_map.hpp"
#include "engine/planning/obstacles/timed_zones.hpp"
#include "engine/planning/obstacles/zone_rules.hpp"
#include "engine/planning/problem/plan_request.hpp"
#include "engine/vehicle/drive.hpp"

namespace floeplan::planning::cost {

/// The environment of one request laid out in its local plane: the one cost function that searches,
/// refinement and published plans share. Times are counted from the request's departure.
/// Threads  const members may be called from several threads at once
class Sea {
 public:
  /// `cell`: step of the safety map. Once `stop` is requested the sea stays incomplete and must not be used.
  /// `environment` and `request` are borrowed and outlive the sea.
  /// `shelf`: where the currents are taken from, if not null; of the same environment, and not needed afterwards.
  Sea(const ocean::Environment& environment, const PlanRequest& request,
      const geo::LocalProjection& projection, const plane::PlaneBox& area, core::Metres cell,
      const std::stop_token& stop = {}, CurrentsShelf* shelf = nullptr);

  /// Why the straight leg is closed at any time, by depth, land, standing zones or standing
  /// icebergs; empty when it is open.
  [[nodiscard]] std::optional<motion::EdgeClosed> closed_between(geo::PlanePoint a, geo::PlanePoint b) const;
  /// Whether no leg from a point that goes no further than `reach` along either axis is closed so: certainly when true.
  [[nodiscard]] bool open_about(geo::PlanePoint point, core::Metres reach) const;
  /// Travel time of a straight leg, or why it is closed; too_late when it would certainly end after `latest`.
  [[nodiscard]] tl::expected<core::Seconds, motion::EdgeClosed> leg_time(geo::PlanePoint a, geo::PlanePoint b,
                                                                         core::Seconds depart,
                                                                         core::Seconds latest = core::Seconds{
                                                                             INFINITY}) const;
  /// The same on one of the request's drives; without it, on the first of them.
  [[nodiscard]] tl::expected<core::Seconds, motion::EdgeClosed> leg_time(geo::PlanePoint a, geo::PlanePoint b,
                                                                         core::Seconds depart,
                                                                         core::Seconds latest,
                                                                         vehicle::Drive drive) const;
  /// What the request's vehicle may be driven by, at least one.
  [[nodiscard]] const std::vector<vehicle::Drive>& drives() const { return drives_; }
  [[nodiscard]] core::MetresPerSecond speed(vehicle::Drive drive) const {
    return drive == vehicle::Drive::thruster ? thruster_speed_ : buoyancy_speed_;
  }
  [[nodiscard]] const energy::EnergyMap& energy() const { return energy_; }
  /// What the straight leg draws that is left then and takes so long, or a wait: the power at each place over the time
  /// that the drive really spends there. Below ice and icebergs the dives turn as deep as they have to, and so more
  /// often.
  /// Where the drive does not get on, what is left of the time goes evenly on what is left of the way.
  /// Accuracy  as `EnergyMeter`, over the bed
  [[nodiscard]] EnergyUse energy_along(geo::PlanePoint a, geo::PlanePoint b, core::Seconds depart,
                                       core::Seconds time, vehicle::Drive drive) const;
  /// Whether every place costs the same at every time, so that energy is power times time.
  [[nodiscard]] bool energy_is_even() const {
    return energy_.is_even() && !(ice() && ice()->has_dense_ice()) && !icebergs().may_pass_under();
  }
  /// The same as if nothing closed and opened in time: never more than `leg_time`, for it drives the same way.
  [[nodiscard]] tl::expected<core::Seconds, motion::EdgeClosed> leg_time_without_timed_closures(
      geo::PlanePoint a, geo::PlanePoint b, core::Seconds depart, core::Seconds latest) const;
  /// The earliest departure, from `depart` on and no later than `latest`, for which nothing that closes for a while is
  /// in the way of a vehicle that goes straight and evenly from a to b in this time; empty: there is none.
  [[nodiscard]] std::optional<core::Seconds> first_clear_departure(geo::PlanePoint a, geo::PlanePoint b,
                                                                   core::Seconds duration,
                                                                   core::Seconds depart,
                                                                   core::Seconds latest) const;
  /// How the vehicle may hold station, metres of the plane; see hold_circle.hpp.
  struct Holding {
    core::Seconds longest{};  // at one place; zero: it never holds
    core::Metres radius{};
    std::optional<core::Metres> radius_below_ice{};  // empty: it does not hold there
    std::shared_ptr<const currents::CurrentEnvelope>
        calm{};  // of a circle; null: nothing is known beforehand
  };
  [[nodiscard]] const Holding& holding() const { return holding_; }
  /// The drive along a leg that is open, as even moves one after the other, each within a metre of it.
  [[nodiscard]] std::vector<motion::EvenMove> drive(geo::PlanePoint a, geo::PlanePoint b,
                                                    core::Seconds depart, vehicle::Drive drive) const;
  /// When a timed zone or an iceberg that moves closes the point: ascending, apart from each other.
  [[nodiscard]] std::vector<TimeSpan> closed_times(geo::PlanePoint point) const;
  /// By timed zones alone.
  [[nodiscard]] std::vector<TimeSpan> closed_times_by_zones(geo::PlanePoint point) const {
    return timed_zones_.closed_times(point);
  }
  /// By icebergs that move alone, whose discs are grown by so many metres of the plane.
  [[nodiscard]] std::vector<TimeSpan> closed_times_by_icebergs(geo::PlanePoint point,
                                                               core::Metres grown = core::Metres{0.0}) const {
    return icebergs().standing() ? std::vector<TimeSpan>{} : icebergs().closed_times(point, grown);
  }
  /// Travel time of the straight leg for a vehicle that is to be at its end at `arrive`: it leaves that much
  /// earlier. Closed where the vehicle that leaves then finds the leg closed; too_late when it would certainly have
  /// to leave before `earliest`.
  [[nodiscard]] tl::expected<core::Seconds, motion::EdgeClosed> leg_time_back(geo::PlanePoint a,
                                                                              geo::PlanePoint b,
                                                                              core::Seconds arrive,
                                                                              core::Seconds earliest) const;
  /// The same as if nothing closed and opened in time.
  [[nodiscard]] tl::expected<core::Seconds, motion::EdgeClosed> leg_time_back_without_timed_closures(
      geo::PlanePoint a, geo::PlanePoint b, core::Seconds arrive, core::Seconds earliest) const;
  /// The same for a vehicle that was `since_surfacing` ago at a place where it might have surfaced; no_surfacing where
  /// that becomes longer than the request allows, anywhere on the leg.
  struct Leg {
    core::Seconds time;
    core::Seconds since_surfacing;  // at its end; zero where nothing is above
  };
  [[nodiscard]] tl::expected<Leg, motion::EdgeClosed> leg(geo::PlanePoint a, geo::PlanePoint b,
                                                          core::Seconds depart,
                                                          core::Seconds since_surfacing) const;
  /// The same on one of the request's drives; without it, on the first of them.
  [[nodiscard]] tl::expected<Leg, motion::EdgeClosed> leg(geo::PlanePoint a, geo::PlanePoint b,
                                                          core::Seconds depart, core::Seconds since_surfacing,
                                                          vehicle::Drive drive) const;
  /// A leg of a vehicle that arrives by `latest`, and what it draws, in one drive. As `leg` where the time without a
  /// possible surfacing is bounded; as `leg_time` otherwise, when the time since the last one is told as zero.
  struct MeteredLeg {
    Leg leg;
    EnergyUse energy;
  };
  [[nodiscard]] tl::expected<MeteredLeg, motion::EdgeClosed> metered_leg(
      geo::PlanePoint a, geo::PlanePoint b, core::Seconds depart, core::Seconds since_surfacing,
      core::Seconds latest, vehicle::Drive drive, Dives dives = Dives::over_bed) const;
  /// As `leg` for a vehicle that is to be at the leg's end at `arrive` and may surface `until_surfacing` later; the
  /// time until it may, at the leg's beginning. too_late when it would certainly have to leave before `earliest`.
  struct LegBack {
    core::Seconds time;
    core::Seconds until_surfacing;
  };
  [[nodiscard]] tl::expected<LegBack, motion::EdgeClosed> leg_back(geo::PlanePoint a, geo::PlanePoint b,
                                                                   core::Seconds arrive,
                                                                   core::Seconds until_surfacing,
                                                                   core::Seconds earliest) const;
  /// Where a vehicle is, and when.
  struct Passage {
    geo::PlanePoint point;
    core::Seconds time;
  };
  /// The vehicle along an open leg, at most `step` apart, its end included and its beginning not.
  [[nodiscard]] std::vector<Passage> passages(geo::PlanePoint a, geo::PlanePoint b, core::Seconds depart,
                                              core::Metres step, vehicle::Drive drive) const;
  /// Never more than the time to where the vehicle may surface, at whatever time it is there; infinite where that is
  /// nowhere.
  [[nodiscard]] core::Seconds least_time_to_opening(geo::PlanePoint point) const;
  /// The same for each point, to where it may surface at some time between these two; in seconds.
  [[nodiscard]] std::vector<double> least_times_to_opening_s(const std::vector<geo::PlanePoint>& points,
                                                             core::Seconds from, core::Seconds until) const;
  /// Encounters with icebergs to expect on the straight way, for searches that weigh them; zero where none does.
  [[nodiscard]] double encounters(geo::PlanePoint a, geo::PlanePoint b, core::Seconds depart,
                                  core::Seconds time) const {
    return encounters_ ? encounters_->along(a, b, depart, time) : 0.0;
  }
  /// The same sea for a vehicle that is driven so all the way.
  [[nodiscard]] Sea driven_by(vehicle::Drive drive) const {
    Sea driven = *this;
    driven.drives_ = {drive};
    return driven;
  }
  /// The same sea for a vehicle that never holds.
  [[nodiscard]] Sea without_holds() const {
    Sea hurried = *this;
    hurried.holding_.longest = core::Seconds{0.0};
    return hurried;
  }
  /// The same sea for a vehicle that may stay below for as long as it takes.
  [[nodiscard]] Sea without_bound_on_surfacing() const {
    Sea unbounded = *this;
    unbounded.overhead_.lift_bound_on_surfacing();
    return unbounded;
  }

  /// Never more than the time of any straight way between the two points.
  [[nodiscard]] core::Seconds least_time(geo::PlanePoint a, geo::PlanePoint b) const;
  /// The same on one drive.
  [[nodiscard]] core::Seconds least_time(geo::PlanePoint a, geo::PlanePoint b, vehicle::Drive drive) const;
  /// Never more than the time of a straight way so long in the plane on which no current is stronger than `astern` in
  /// its direction.
  [[nodiscard]] core::Seconds least_time(core::Metres length, core::MetresPerSecond astern) const;
  /// Whether nothing here changes with time: no matter when a leg is travelled.
  [[nodiscard]] bool is_steady() const;

  /// Whether the currents are known there from that time to their end, as far as looks at equal distances in time tell;
  /// true in still water.
  [[nodiscard]] bool currents_known_to_end(geo::PlanePoint point, core::Seconds from) const;

  [[nodiscard]] core::MetresPerSecond through_water() const { return speed(drives_.front()); }
  [[nodiscard]] const geo::LocalProjection& projection() const { return projection_; }
  [[nodiscard]] const obstacles::SafetyMap& safety() const { return safety_; }
  [[nodiscard]] obstacles::SafetyMap& safety() { return safety_; }
  /// What is above the vehicle.
  [[nodiscard]] const Overhead& overhead() const { return overhead_; }
  [[nodiscard]] const obstacles::IcebergDiscs& icebergs() const { return overhead_.icebergs(); }
  /// Whether something is closed at some times only, so that arriving later can be better.
  [[nodiscard]] bool has_timed_closures() const { return !timed_zones_.empty() || !icebergs().standing(); }
  [[nodiscard]] const obstacles::TimedZones& timed_zones() const { return timed_zones_; }
  [[nodiscard]] const std::optional<ice::UnderIce>& ice() const { return overhead_.ice(); }
  /// Null: still water.
  [[nodiscard]] const currents::PlaneCurrents* currents() const { return currents_.get(); }
  [[nodiscard]] core::Metres ground_length(geo::PlanePoint a, geo::PlanePoint b) const;
  /// Metres on the ground for one of the plane: never more than on any line of this length that leaves the point.
  [[nodiscard]] double least_ground_per_plane(geo::PlanePoint from, core::Metres length) const;
  [[nodiscard]] double edge_tolerance() const { return edge_tolerance_; }

  /// Of what is laid out, without the data that it was laid out from.
  [[nodiscard]] std::size_t bytes() const;

 private:
  Sea(const ocean::Environment& environment, const PlanRequest& request, obstacles::ZoneRules zones,
      const geo::LocalProjection& projection, const plane::PlaneBox& area, core::Metres cell,
      const std::stop_token& stop, CurrentsShelf* shelf);
  [[nodiscard]] double scale_at(geo::PlanePoint point) const;
  /// Whether a timed zone or an iceberg that moves closes a piece of a drive.
  [[nodiscard]] std::optional<motion::EdgeClosed> closed_then(const motion::PlaneEdge& edge,
                                                              const motion::EdgePiece& piece,
                                                              double error_m) const;
  /// Of an edge that nothing closes, for who is to be at its end then.
  [[nodiscard]] tl::expected<core::Seconds, motion::EdgeClosed> drive_time_back(const motion::PlaneEdge& edge,
                                                                                core::Seconds arrive,
                                                                                core::Seconds earliest) const;
  template <class VisitPiece>
  [[nodiscard]] tl::expected<core::Seconds, motion::EdgeClosed> drive_time(
      const motion::PlaneEdge& edge, core::Seconds depart, core::Seconds latest,
      core::MetresPerSecond through_water, const VisitPiece& visit) const;

  geo::LocalProjection projection_;
  plane::PlaneBox area_;
  std::vector<vehicle::Drive> drives_;
  core::MetresPerSecond buoyancy_speed_;
  core::MetresPerSecond thruster_speed_;  // as the buoyancy drive where there is none
  double edge_tolerance_;
  motion::EdgeAccuracy accuracy_;
  obstacles::SafetyMap safety_;
  obstacles::TimedZones timed_zones_;
  std::shared_ptr<const obstacles::BedCells>
      bed_;  // for icebergs and ice; null where no iceberg may be passed under
  Overhead overhead_;
  std::optional<obstacles::EncounterMap> encounters_;  // empty: nothing weighs them
  currents::FlownDepths depths_;
  std::shared_ptr<const currents::PlaneCurrents>
      currents_;  // null: still water; seas laid out alike share it
  energy::EnergyMap energy_;
  Holding holding_;
  std::vector<double> scales_;  // of the projection, [y][x] on a coarse lattice over the area
  double largest_scale_{1.0};
  double steepest_scale_{};  // change of the scale over a metre of the plane at most
  core::MetresPerSecond fastest_through_water_;
  double least_slowness_s_m_;  // for each metre on the ground, with the strongest current astern
};

}  // namespace floeplan::planning::cost

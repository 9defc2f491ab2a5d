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
#include "engine/planning/cost/energy_meter.hpp"
#include "engine/planning/cost/planning_domain.hpp"
#include "engine/planning/currents/current_envelope.hpp"
#include "engine/planning/energy/energy_map.hpp"
#include "engine/planning/obstacles/encounter_map.hpp"
#include "engine/planning/problem/plan_request.hpp"
#include "engine/vehicle/drive.hpp"

namespace floeplan::planning::cost {

/// The leg cost model of one request: what it takes to travel a straight leg of its planning domain, in time, energy
/// and encounters with icebergs. Searches, refinement and published plans share it, so all of them use the same cost.
/// Times count from the departure of the request.
/// Threads  const members may be called from several threads at once
class Sea {
 public:
  /// `cell`: step of the safety map. Once `stop` is requested, the object stays incomplete and must not be
  /// used.
  /// `environment` and `request` are borrowed and must outlive the object.
  /// `shelf`: cache of gridded parts, or null; needed only during construction.
  Sea(const ocean::Environment& environment, const PlanRequest& request,
      const geo::LocalProjection& projection, const plane::PlaneBox& area, core::Metres cell,
      const std::stop_token& stop = {}, SeaShelf* shelf = nullptr);

  /// Travel time of a straight leg with the first propulsion of the model, or the reason why the leg is
  /// closed. too_late: it would certainly end after `latest`.
  [[nodiscard]] tl::expected<core::Seconds, motion::EdgeClosed> leg_time(geo::PlanePoint a, geo::PlanePoint b,
                                                                         core::Seconds depart,
                                                                         core::Seconds latest = core::Seconds{
                                                                             INFINITY}) const;
  /// Travel time of a straight leg with the given propulsion, which the request must allow.
  [[nodiscard]] tl::expected<core::Seconds, motion::EdgeClosed> leg_time(geo::PlanePoint a, geo::PlanePoint b,
                                                                         core::Seconds depart,
                                                                         core::Seconds latest,
                                                                         vehicle::Drive drive) const;
  /// The kinds of propulsion that the request's vehicle may use; at least one.
  [[nodiscard]] const std::vector<vehicle::Drive>& drives() const { return drives_; }
  [[nodiscard]] core::MetresPerSecond speed(vehicle::Drive drive) const {
    return drive == vehicle::Drive::thruster ? thruster_speed_ : buoyancy_speed_;
  }
  [[nodiscard]] const energy::EnergyMap& energy() const { return energy_; }
  /// Energy of a straight leg that starts at `depart` and takes `time`, or of a hold: the power at each place
  /// times the time spent there. Below ice and icebergs the dives turn deeper, so they are shorter and more
  /// of them are needed. If the current stops the vehicle, it covers the rest of the leg at constant speed in
  /// the rest of the time.
  /// Accuracy  as `EnergyMeter`, over the sea bed
  [[nodiscard]] EnergyUse energy_along(geo::PlanePoint a, geo::PlanePoint b, core::Seconds depart,
                                       core::Seconds time, vehicle::Drive drive) const;
  /// Whether the power is the same everywhere and at every time, so that energy is power times time.
  [[nodiscard]] bool energy_is_even() const {
    return energy_.is_even() && !(domain_.ice() && domain_.ice()->has_dense_ice()) &&
           !domain_.icebergs().may_pass_under();
  }
  /// Travel time of a straight leg if closures that end are ignored. Never more than `leg_time`: the drive is
  /// the same.
  [[nodiscard]] tl::expected<core::Seconds, motion::EdgeClosed> leg_time_without_timed_closures(
      geo::PlanePoint a, geo::PlanePoint b, core::Seconds depart, core::Seconds latest) const;
  /// How the vehicle may hold station; lengths in metres of the plane. See hold_circle.hpp.
  struct Holding {
    core::Seconds longest{};  // at one place; zero: the vehicle never holds
    core::Metres radius{};
    std::optional<core::Metres> radius_below_ice{};  // empty: the vehicle does not hold below ice
    std::shared_ptr<const currents::CurrentEnvelope>
        calm{};  // strongest current within a circle; null: not precomputed
  };
  [[nodiscard]] const Holding& holding() const { return holding_; }
  /// The drive along an open leg as moves at constant speed, in order. Each stays within a metre of the true
  /// drive.
  [[nodiscard]] std::vector<motion::EvenMove> drive(geo::PlanePoint a, geo::PlanePoint b,
                                                    core::Seconds depart, vehicle::Drive drive) const;
  /// Travel time of the straight leg for a vehicle that must arrive at `arrive`; so its departure is `arrive`
  /// minus that time. Closed if the leg is closed for this departure. too_late: the departure would certainly
  /// be before `earliest`.
  [[nodiscard]] tl::expected<core::Seconds, motion::EdgeClosed> leg_time_back(geo::PlanePoint a,
                                                                              geo::PlanePoint b,
                                                                              core::Seconds arrive,
                                                                              core::Seconds earliest) const;
  /// `leg_time_back` if closures that end are ignored.
  [[nodiscard]] tl::expected<core::Seconds, motion::EdgeClosed> leg_time_back_without_timed_closures(
      geo::PlanePoint a, geo::PlanePoint b, core::Seconds arrive, core::Seconds earliest) const;
  /// Travel time of a leg, and the time since the last possible surfacing. `since_surfacing`: that time at
  /// the departure. no_surfacing: somewhere on the leg that time exceeds the limit of the request.
  struct Leg {
    core::Seconds time;
    core::Seconds since_surfacing;  // at the end of the leg; zero where nothing is above the vehicle
  };
  [[nodiscard]] tl::expected<Leg, motion::EdgeClosed> leg(geo::PlanePoint a, geo::PlanePoint b,
                                                          core::Seconds depart,
                                                          core::Seconds since_surfacing) const;
  /// `leg` with the given propulsion, which the request must allow. The overload without it uses the first
  /// one.
  [[nodiscard]] tl::expected<Leg, motion::EdgeClosed> leg(geo::PlanePoint a, geo::PlanePoint b,
                                                          core::Seconds depart, core::Seconds since_surfacing,
                                                          vehicle::Drive drive) const;
  /// A leg that must end by `latest`, with its energy, from one integration. If the time without surfacing is
  /// limited, the leg equals the result of `leg`. Otherwise its time equals the result of `leg_time`, and
  /// `since_surfacing` is zero.
  struct MeteredLeg {
    Leg leg;
    EnergyUse energy;
  };
  [[nodiscard]] tl::expected<MeteredLeg, motion::EdgeClosed> metered_leg(
      geo::PlanePoint a, geo::PlanePoint b, core::Seconds depart, core::Seconds since_surfacing,
      core::Seconds latest, vehicle::Drive drive, Dives dives = Dives::over_bed) const;
  /// `leg` backwards: the vehicle must arrive at `arrive` and may surface `until_surfacing` later. Returns
  /// the travel time and the time from the beginning of the leg to that surfacing. too_late: the departure
  /// would certainly be before `earliest`.
  struct LegBack {
    core::Seconds time;
    core::Seconds until_surfacing;
  };
  [[nodiscard]] tl::expected<LegBack, motion::EdgeClosed> leg_back(geo::PlanePoint a, geo::PlanePoint b,
                                                                   core::Seconds arrive,
                                                                   core::Seconds until_surfacing,
                                                                   core::Seconds earliest) const;
  /// A place and the time at which the vehicle is there.
  struct Passage {
    geo::PlanePoint point;
    core::Seconds time;
  };
  /// Places of the vehicle along an open leg, at most `step` apart. The end of the leg is included, its beginning is
  /// not.
  [[nodiscard]] std::vector<Passage> passages(geo::PlanePoint a, geo::PlanePoint b, core::Seconds depart,
                                              core::Metres step, vehicle::Drive drive) const;
  /// Lower bound, at all times, of the travel time to a place where the vehicle may surface. Infinite if
  /// there is none.
  [[nodiscard]] core::Seconds least_time_to_opening(geo::PlanePoint point) const;
  /// The bound of `least_time_to_opening` in seconds for each point, for places where the vehicle may surface
  /// at some time between `from` and `until`.
  [[nodiscard]] std::vector<double> least_times_to_opening_s(const std::vector<geo::PlanePoint>& points,
                                                             core::Seconds from, core::Seconds until) const;
  /// Expected number of encounters with icebergs on the straight leg, if the objective weighs them; otherwise
  /// zero.
  [[nodiscard]] double encounters(geo::PlanePoint a, geo::PlanePoint b, core::Seconds depart,
                                  core::Seconds time) const {
    return encounters_ ? encounters_->along(a, b, depart, time) : 0.0;
  }
  /// Which parts of the request another model leaves out.
  struct Variant {
    std::optional<vehicle::Drive> drive{};  // this propulsion alone; empty: all of the request
    bool holds{true};                       // false: the vehicle never holds
    bool bounds_surfacing{true};            // false: without a limit on the time without surfacing
  };
  /// A copy of this model with those parts left out.
  [[nodiscard]] Sea with(const Variant& variant) const;

  /// Lower bound of the time of any straight leg between the two points.
  [[nodiscard]] core::Seconds least_time(geo::PlanePoint a, geo::PlanePoint b) const;
  /// Lower bound of the time of any straight leg between the two points, with this propulsion.
  [[nodiscard]] core::Seconds least_time(geo::PlanePoint a, geo::PlanePoint b, vehicle::Drive drive) const;
  /// Lower bound of the time of a straight leg of this length in the plane, if no current along it exceeds
  /// `astern`.
  [[nodiscard]] core::Seconds least_time(core::Metres length, core::MetresPerSecond astern) const;
  [[nodiscard]] core::MetresPerSecond through_water() const { return speed(drives_.front()); }
  /// Where and when the vehicle may be, and in what currents.
  [[nodiscard]] const PlanningDomain& domain() const { return domain_; }
  [[nodiscard]] PlanningDomain& domain() { return domain_; }
  [[nodiscard]] double edge_tolerance() const { return edge_tolerance_; }

  /// Memory of the precomputed grids in bytes, without the data they were made from.
  [[nodiscard]] std::size_t bytes() const;

 private:
  /// Travel time of an edge that nothing closes, for a vehicle that must arrive at `arrive`.
  [[nodiscard]] tl::expected<core::Seconds, motion::EdgeClosed> drive_time_back(const motion::PlaneEdge& edge,
                                                                                core::Seconds arrive,
                                                                                core::Seconds earliest) const;
  template <class VisitPiece>
  [[nodiscard]] tl::expected<core::Seconds, motion::EdgeClosed> drive_time(
      const motion::PlaneEdge& edge, core::Seconds depart, core::Seconds latest,
      core::MetresPerSecond through_water, const VisitPiece& visit) const;

  PlanningDomain domain_;
  std::vector<vehicle::Drive> drives_;
  core::MetresPerSecond buoyancy_speed_;
  core::MetresPerSecond thruster_speed_;  // equal to the buoyancy speed if there is no thruster
  double edge_tolerance_;
  motion::EdgeAccuracy accuracy_;
  std::optional<obstacles::EncounterMap> encounters_;  // empty: the objective does not weigh encounters
  energy::EnergyMap energy_;
  Holding holding_;
  core::MetresPerSecond fastest_through_water_;
  double least_slowness_s_m_;  // s per metre on the ground, with the strongest current from astern
};

}  // namespace floeplan::planning::cost

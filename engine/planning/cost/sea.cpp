#include "engine/planning/cost/sea.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/motion/drive_looks.hpp"
#include "engine/motion/edge_time_back.hpp"
#include "engine/planning/cost/sea_layout.hpp"
#include "engine/planning/cost/surfacing_watch.hpp"
#include "engine/planning/currents/current_drive.hpp"
#include "engine/planning/problem/position_error.hpp"

namespace floeplan::planning::cost {
namespace {

/// `fastest`: speed of the fastest propulsion, because the dead-reckoning error grows with speed. `scale`:
/// metres of the plane per metre on the ground.
Sea::Holding holding_of(const PlanRequest& request, core::MetresPerSecond fastest, double scale,
                        const currents::PlaneCurrents* currents) {
  Sea::Holding holding{.longest = request.holds.longest, .radius = scale * request.holds.radius};
  const UnderIceRules& ice = request.under_ice;
  if (const auto longest = ice.max_time_without_surfacing) {
    const core::Metres error = grown_error(ice, fastest, *longest);
    holding.radius_below_ice = holding.radius + scale * error;
  }
  if (holding.longest.count() > 0.0 && currents != nullptr)
    holding.calm = std::make_shared<currents::CurrentEnvelope>(*currents, holding.radius);
  return holding;
}

}  // namespace

Sea::Sea(const ocean::Environment& environment, const PlanRequest& request,
         const geo::LocalProjection& projection, const plane::PlaneBox& area, core::Metres cell,
         const std::stop_token& stop, SeaShelf* shelf)
    : domain_{environment, request, projection, area, cell, stop, shelf},
      drives_{planning::drives(request.energy, request.vehicle)},
      buoyancy_speed_{request.vehicle.speed_through_water},
      thruster_speed_{request.vehicle.thruster ? request.vehicle.thruster->speed : buoyancy_speed_},
      edge_tolerance_{request.edge_tolerance},
      accuracy_{currents::drive_accuracy(domain_.currents(), request.edge_tolerance)},
      encounters_{lay_out_encounters(domain_.icebergs(), environment, request, area, stop)},
      energy_{request.vehicle, domain_.depths(), projection, area, stop} {
  fastest_through_water_ = std::max(speed(drives_.front()), speed(drives_.back()));
  const core::MetresPerSecond astern{domain_.currents() ? domain_.currents()->strongest().value : 0.0};
  // Slightly below the bound, because integrated times have an error of the tolerance.
  least_slowness_s_m_ = (1.0 - request.edge_tolerance) / (fastest_through_water_ + astern).value;
  holding_ =
      holding_of(request, fastest_through_water_, domain_.lengths().largest_scale(), domain_.currents());
}

std::size_t Sea::bytes() const { return domain_.bytes() + energy_.bytes(); }

EnergyUse Sea::energy_along(geo::PlanePoint a, geo::PlanePoint b, core::Seconds depart, core::Seconds time,
                            vehicle::Drive drive) const {
  const motion::PlaneEdge edge{a, b, domain_.lengths().between(a, b)};
  EnergyMeter meter{energy_, domain_.overhead(), edge, depart, drive, Dives::over_bed};
  (void)drive_time(edge, depart, core::Seconds{INFINITY}, speed(drive),
                   [&](const motion::EdgePiece& piece) -> std::optional<motion::EdgeClosed> {
                     meter.add(piece);
                     return std::nullopt;
                   });
  return meter.until(depart + time);
}

template <class VisitPiece>
tl::expected<core::Seconds, motion::EdgeClosed> Sea::drive_time(const motion::PlaneEdge& edge,
                                                                core::Seconds depart, core::Seconds latest,
                                                                core::MetresPerSecond through_water,
                                                                const VisitPiece& visit) const {
  return planning::currents::drive_time(domain_.currents(), edge, depart, through_water, accuracy_, latest,
                                        visit);
}

tl::expected<core::Seconds, motion::EdgeClosed> Sea::leg_time(geo::PlanePoint a, geo::PlanePoint b,
                                                              core::Seconds depart,
                                                              core::Seconds latest) const {
  return leg_time(a, b, depart, latest, drives_.front());
}

tl::expected<core::Seconds, motion::EdgeClosed> Sea::leg_time(geo::PlanePoint a, geo::PlanePoint b,
                                                              core::Seconds depart, core::Seconds latest,
                                                              vehicle::Drive drive) const {
  if (const auto closed = domain_.closures().closed_between(a, b)) return tl::unexpected(*closed);
  const bool ice_may_close = domain_.ice() && domain_.ice()->may_close(a, b);
  if (!domain_.closures().any_timed() && !ice_may_close) {
    return drive_time({a, b, domain_.lengths().between(a, b)}, depart, latest, speed(drive),
                      motion::VisitNoPiece{});
  }
  const motion::PlaneEdge edge{a, b, domain_.lengths().between(a, b)};
  const double error_m = edge_tolerance_ * geo::distance_m(a, b);
  return drive_time(edge, depart, latest, speed(drive),
                    [&](const motion::EdgePiece& piece) -> std::optional<motion::EdgeClosed> {
                      if (const auto closed = domain_.closures().closed_during(edge, piece, error_m))
                        return closed;
                      if (ice_may_close && !domain_.ice()->may_transit_along(edge, piece))
                        return motion::EdgeClosed::under_ice;
                      return std::nullopt;
                    });
}

tl::expected<core::Seconds, motion::EdgeClosed> Sea::leg_time_without_timed_closures(
    geo::PlanePoint a, geo::PlanePoint b, core::Seconds depart, core::Seconds latest) const {
  if (const auto closed = domain_.closures().closed_between(a, b)) return tl::unexpected(*closed);
  return drive_time({a, b, domain_.lengths().between(a, b)}, depart, latest, speed(drives_.front()),
                    motion::VisitNoPiece{});
}

std::vector<motion::EvenMove> Sea::drive(geo::PlanePoint a, geo::PlanePoint b, core::Seconds depart,
                                         vehicle::Drive drive) const {
  std::vector<motion::EvenMove> moves;
  const motion::PlaneEdge edge{a, b, domain_.lengths().between(a, b)};
  const auto follow = [&](const motion::EdgePiece& piece) -> std::optional<motion::EdgeClosed> {
    constexpr double most_deviation_m = 1.0;
    return motion::follow_piece(
        edge, piece, most_deviation_m,
        [&](const motion::EvenMove& move, double) -> std::optional<motion::EdgeClosed> {
          moves.push_back(move);
          return std::nullopt;
        });
  };
  (void)drive_time(edge, depart, core::Seconds{INFINITY}, speed(drive), follow);
  return moves;
}

tl::expected<core::Seconds, motion::EdgeClosed> Sea::drive_time_back(const motion::PlaneEdge& edge,
                                                                     core::Seconds arrive,
                                                                     core::Seconds earliest) const {
  if (!domain_.currents()) return edge.ground_length / through_water();
  return motion::edge_time_back(edge, arrive, through_water(), *domain_.currents(), accuracy_, earliest);
}

tl::expected<core::Seconds, motion::EdgeClosed> Sea::leg_time_back(geo::PlanePoint a, geo::PlanePoint b,
                                                                   core::Seconds arrive,
                                                                   core::Seconds earliest) const {
  if (const auto closed = domain_.closures().closed_between(a, b)) return tl::unexpected(*closed);
  const auto time = drive_time_back({a, b, domain_.lengths().between(a, b)}, arrive, earliest);
  const bool ice_may_close = domain_.ice() && domain_.ice()->may_close(a, b);
  if (!time || !(domain_.closures().any_timed() || ice_may_close)) return time;
  // Timed closures and the room below the ice are tested along the drive itself.
  const auto forwards = leg_time(a, b, arrive - *time);
  if (!forwards) return tl::unexpected(forwards.error());
  return time;
}

tl::expected<core::Seconds, motion::EdgeClosed> Sea::leg_time_back_without_timed_closures(
    geo::PlanePoint a, geo::PlanePoint b, core::Seconds arrive, core::Seconds earliest) const {
  if (const auto closed = domain_.closures().closed_between(a, b)) return tl::unexpected(*closed);
  return drive_time_back({a, b, domain_.lengths().between(a, b)}, arrive, earliest);
}

tl::expected<Sea::Leg, motion::EdgeClosed> Sea::leg(geo::PlanePoint a, geo::PlanePoint b,
                                                    core::Seconds depart,
                                                    core::Seconds since_surfacing) const {
  return leg(a, b, depart, since_surfacing, drives_.front());
}

tl::expected<Sea::Leg, motion::EdgeClosed> Sea::leg(geo::PlanePoint a, geo::PlanePoint b,
                                                    core::Seconds depart, core::Seconds since_surfacing,
                                                    vehicle::Drive drive) const {
  constexpr core::Seconds never{INFINITY};
  if (!domain_.ice() && !domain_.overhead().bounds_surfacing()) {
    return leg_time(a, b, depart, never, drive).map([](core::Seconds time) {
      return Leg{time, core::Seconds{0.0}};
    });
  }
  if (const auto closed = domain_.closures().closed_between(a, b)) return tl::unexpected(*closed);
  const motion::PlaneEdge edge{a, b, domain_.lengths().between(a, b)};
  SurfacingWatch watch{domain_.overhead(), edge, since_surfacing};
  const double error_m = edge_tolerance_ * geo::distance_m(a, b);
  const auto time =
      drive_time(edge, depart, never, speed(drive),
                 [&](const motion::EdgePiece& piece) -> std::optional<motion::EdgeClosed> {
                   if (const auto closed = domain_.closures().closed_during(edge, piece, error_m))
                     return closed;
                   return watch(piece);
                 });
  if (!time) return tl::unexpected(time.error());
  return Leg{*time, watch.since_surfacing()};
}

tl::expected<Sea::MeteredLeg, motion::EdgeClosed> Sea::metered_leg(geo::PlanePoint a, geo::PlanePoint b,
                                                                   core::Seconds depart,
                                                                   core::Seconds since_surfacing,
                                                                   core::Seconds latest, vehicle::Drive drive,
                                                                   Dives dives) const {
  if (const auto closed = domain_.closures().closed_between(a, b)) return tl::unexpected(*closed);
  const motion::PlaneEdge edge{a, b, domain_.lengths().between(a, b)};
  const double error_m = edge_tolerance_ * geo::distance_m(a, b);
  const bool ice_may_close = domain_.ice() && domain_.ice()->may_close(a, b);
  std::optional<SurfacingWatch> watch;
  if (domain_.overhead().bounds_surfacing()) watch.emplace(domain_.overhead(), edge, since_surfacing);
  EnergyMeter meter{energy_, domain_.overhead(), edge, depart, drive, dives};
  const auto time =
      drive_time(edge, depart, latest, speed(drive),
                 [&](const motion::EdgePiece& piece) -> std::optional<motion::EdgeClosed> {
                   if (const auto closed = domain_.closures().closed_during(edge, piece, error_m))
                     return closed;
                   if (watch) {
                     if (const auto closed = (*watch)(piece)) return closed;
                   } else if (ice_may_close && !domain_.ice()->may_transit_along(edge, piece)) {
                     return motion::EdgeClosed::under_ice;
                   }
                   meter.add(piece);
                   return std::nullopt;
                 });
  if (!time) return tl::unexpected(time.error());
  const core::Seconds since = watch ? watch->since_surfacing() : core::Seconds{0.0};
  return MeteredLeg{{*time, since}, meter.until(depart + *time)};
}

tl::expected<Sea::LegBack, motion::EdgeClosed> Sea::leg_back(geo::PlanePoint a, geo::PlanePoint b,
                                                             core::Seconds arrive,
                                                             core::Seconds until_surfacing,
                                                             core::Seconds earliest) const {
  if (const auto closed = domain_.closures().closed_between(a, b)) return tl::unexpected(*closed);
  const motion::PlaneEdge edge{a, b, domain_.lengths().between(a, b)};
  const auto time = drive_time_back(edge, arrive, earliest);
  if (!time) return tl::unexpected(time.error());
  const core::Seconds depart = arrive - *time;
  SurfacingOutlook outlook{domain_.overhead(), edge, depart};
  const double error_m = edge_tolerance_ * geo::distance_m(a, b);
  const auto forwards =
      drive_time(edge, depart, core::Seconds{INFINITY}, through_water(),
                 [&](const motion::EdgePiece& piece) -> std::optional<motion::EdgeClosed> {
                   if (const auto closed = domain_.closures().closed_during(edge, piece, error_m))
                     return closed;
                   return outlook(piece);
                 });
  if (!forwards) return tl::unexpected(forwards.error());
  return outlook.until_surfacing(until_surfacing).map([&](core::Seconds until) {
    return LegBack{*time, until};
  });
}

core::Seconds Sea::least_time_to_opening(geo::PlanePoint point) const {
  const core::Metres way = domain_.ice() ? domain_.ice()->least_way_to_opening(point) : core::Metres{0.0};
  return core::Seconds{least_slowness_s_m_ * way.value / domain_.lengths().largest_scale()};
}

std::vector<double> Sea::least_times_to_opening_s(const std::vector<geo::PlanePoint>& points,
                                                  core::Seconds from, core::Seconds until) const {
  std::vector<double> times_s(points.size(), 0.0);
  if (!domain_.ice()) return times_s;
  const std::vector<core::Metres> ways = domain_.ice()->least_ways_to_opening(points, from, until);
  for (std::size_t i = 0; i < ways.size(); ++i)
    times_s[i] = least_slowness_s_m_ * ways[i].value / domain_.lengths().largest_scale();
  return times_s;
}

std::vector<Sea::Passage> Sea::passages(geo::PlanePoint a, geo::PlanePoint b, core::Seconds depart,
                                        core::Metres step, vehicle::Drive drive) const {
  std::vector<Passage> result;
  const motion::PlaneEdge edge{a, b, domain_.lengths().between(a, b)};
  const auto note = [&](const motion::EdgePiece& piece) -> std::optional<motion::EdgeClosed> {
    motion::look_along(edge, piece, step, [&](geo::PlanePoint point, core::Seconds time) {
      result.push_back({point, time});
      return true;
    });
    return std::nullopt;
  };
  [[maybe_unused]] const auto time = drive_time(edge, depart, core::Seconds{INFINITY}, speed(drive), note);
  return result;
}

Sea Sea::with(const Variant& variant) const {
  Sea other = *this;
  if (variant.drive) other.drives_ = {*variant.drive};
  if (!variant.holds) other.holding_.longest = core::Seconds{0.0};
  if (!variant.bounds_surfacing) other.domain_.lift_bound_on_surfacing();
  return other;
}

core::Seconds Sea::least_time(geo::PlanePoint a, geo::PlanePoint b, vehicle::Drive drive) const {
  const core::MetresPerSecond astern{domain_.currents() ? domain_.currents()->strongest().value : 0.0};
  const core::Metres least_length{geo::distance_m(a, b) / domain_.lengths().largest_scale()};
  return (1.0 - edge_tolerance_) * (least_length / (speed(drive) + astern));
}

core::Seconds Sea::least_time(core::Metres length, core::MetresPerSecond astern) const {
  const core::MetresPerSecond fastest =
      fastest_through_water_ + std::min(astern, domain_.currents()->strongest());
  if (fastest.value <= 0.0) return core::Seconds{INFINITY};
  return (1.0 - edge_tolerance_) * ((1.0 / domain_.lengths().largest_scale()) * length / fastest);
}

core::Seconds Sea::least_time(geo::PlanePoint a, geo::PlanePoint b) const {
  return core::Seconds{least_slowness_s_m_ * geo::distance_m(a, b) / domain_.lengths().largest_scale()};
}

}  // namespace floeplan::planning::cost

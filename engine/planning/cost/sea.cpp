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

constexpr int scale_cells =
    64;  // cells on each side: the scale is smooth, so its error within a cell is far below the tolerance

/// Largest change of the scale per metre of the plane, in any direction.
double steepest_scale(const std::vector<double>& scales, const plane::PlaneBox& area) {
  constexpr std::size_t row = scale_cells + 1;
  double along_x = 0.0;
  double along_y = 0.0;
  for (std::size_t i = 0; i < scales.size(); ++i) {
    if ((i + 1) % row != 0) along_x = std::max(along_x, std::abs(scales[i + 1] - scales[i]));
    if (i + row < scales.size()) along_y = std::max(along_y, std::abs(scales[i + row] - scales[i]));
  }
  return std::hypot(along_x * scale_cells / area.width_m(), along_y * scale_cells / area.height_m());
}

/// `fastest`: of all propulsion, because the dead-reckoning error grows with speed. `scale`: metres of the plane per
/// metre on the ground.
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
         const std::stop_token& stop, CurrentsShelf* shelf)
    : Sea{environment, request, lay_out_zones(environment, request), projection, area, cell, stop, shelf} {}

Sea::Sea(const ocean::Environment& environment, const PlanRequest& request, obstacles::ZoneRules zones,
         const geo::LocalProjection& projection, const plane::PlaneBox& area, core::Metres cell,
         const std::stop_token& stop, CurrentsShelf* shelf)
    : projection_{projection},
      area_{area},
      drives_{planning::drives(request.energy, request.vehicle)},
      buoyancy_speed_{request.vehicle.speed_through_water},
      thruster_speed_{request.vehicle.thruster ? request.vehicle.thruster->speed : buoyancy_speed_},
      edge_tolerance_{request.edge_tolerance},
      safety_{environment, request.vehicle.least_water(), std::move(zones.standing), projection, area, cell,
              stop},
      timed_zones_{lay_out_timed_zones(zones.timed, request, projection, area)},
      bed_{lay_out_bed_below(environment, request, projection, area, cell, stop)},
      overhead_{lay_out_ice(environment, request, projection, area, cell, bed_, stop),
                lay_out_icebergs(environment, request, projection, area, bed_, stop),
                request.under_ice.max_time_without_surfacing},
      encounters_{lay_out_encounters(icebergs(), environment, request, area, stop)},
      depths_{request.vehicle.dive_limits(), environment.bathymetry},
      currents_{shelf != nullptr
                    ? shelf->take(request, depths_, ice() ? &*ice() : nullptr, projection, area, stop)
                    : lay_out_currents(environment, request, depths_, ice() ? &*ice() : nullptr, projection,
                                       area, stop)},
      energy_{request.vehicle, depths_, projection, area, stop} {
  accuracy_ = currents::drive_accuracy(currents_.get(), request.edge_tolerance);
  for (int iy = 0; iy <= scale_cells; ++iy) {
    for (int ix = 0; ix <= scale_cells; ++ix) {
      const geo::PlanePoint point{area.low.x_m + area.width_m() * ix / scale_cells,
                                  area.low.y_m + area.height_m() * iy / scale_cells};
      scales_.push_back(projection_.at(projection_.to_lon_lat(point)).scale);
    }
  }
  largest_scale_ = std::ranges::max(scales_);
  steepest_scale_ = steepest_scale(scales_, area);
  fastest_through_water_ = std::max(speed(drives_.front()), speed(drives_.back()));
  const core::MetresPerSecond astern{currents_ ? currents_->strongest().value : 0.0};
  // Slightly below the bound, because integrated times have an error of the tolerance.
  least_slowness_s_m_ = (1.0 - request.edge_tolerance) / (fastest_through_water_ + astern).value;
  holding_ = holding_of(request, fastest_through_water_, largest_scale_, currents_.get());
}

std::size_t Sea::bytes() const {
  // The memory of the shared bed is counted with the ice.
  const std::size_t of_bed = bed_ && !ice() ? bed_->bytes() : 0;
  return safety_.bytes() + icebergs().bytes() + energy_.bytes() + of_bed + (ice() ? ice()->bytes() : 0) +
         (currents_ ? currents_->bytes() : 0);
}

double Sea::scale_at(geo::PlanePoint point) const {
  const double x = std::clamp((point.x_m - area_.low.x_m) / area_.width_m(), 0.0, 1.0) * scale_cells;
  const double y = std::clamp((point.y_m - area_.low.y_m) / area_.height_m(), 0.0, 1.0) * scale_cells;
  const int ix = std::min(static_cast<int>(x), scale_cells - 1);
  const int iy = std::min(static_cast<int>(y), scale_cells - 1);
  const double fx = x - ix;
  const double fy = y - iy;
  const double* row = scales_.data() + static_cast<std::ptrdiff_t>(iy) * (scale_cells + 1) + ix;
  const double south = row[0] + fx * (row[1] - row[0]);
  const double north = row[scale_cells + 1] + fx * (row[scale_cells + 2] - row[scale_cells + 1]);
  return south + fy * (north - south);
}

core::Metres Sea::ground_length(geo::PlanePoint a, geo::PlanePoint b) const {
  // Simpson's rule for the mean of 1/scale along the line.
  const geo::PlanePoint middle{0.5 * (a.x_m + b.x_m), 0.5 * (a.y_m + b.y_m)};
  const double mean = (1.0 / scale_at(a) + 4.0 / scale_at(middle) + 1.0 / scale_at(b)) / 6.0;
  return core::Metres{mean * geo::distance_m(a, b)};
}

double Sea::least_ground_per_plane(geo::PlanePoint from, core::Metres length) const {
  return 1.0 / (scale_at(from) + steepest_scale_ * length.value);
}

std::optional<motion::EdgeClosed> Sea::closed_between(geo::PlanePoint a, geo::PlanePoint b) const {
  if (const auto closed = safety_.closed_between(a, b)) return closed;
  constexpr double at_any_time_s = 1.0;
  if (icebergs().standing() && icebergs().touched({a, b, 0.0, at_any_time_s}))
    return motion::EdgeClosed::obstacle;
  return std::nullopt;
}

bool Sea::open_about(geo::PlanePoint point, core::Metres reach) const {
  const bool may_stand = icebergs().standing() && !icebergs().empty();
  return !may_stand && safety_.open_about(point, reach);
}

EnergyUse Sea::energy_along(geo::PlanePoint a, geo::PlanePoint b, core::Seconds depart, core::Seconds time,
                            vehicle::Drive drive) const {
  const motion::PlaneEdge edge{a, b, ground_length(a, b)};
  EnergyMeter meter{energy_, overhead_, edge, depart, drive, Dives::over_bed};
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
  return planning::currents::drive_time(currents_.get(), edge, depart, through_water, accuracy_, latest,
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
  if (const auto closed = closed_between(a, b)) return tl::unexpected(*closed);
  const bool below_ice = ice() && ice()->may_be_dense_along(a, b);
  if (!has_timed_closures() && !below_ice) {
    return drive_time({a, b, ground_length(a, b)}, depart, latest, speed(drive), motion::VisitNoPiece{});
  }
  const motion::PlaneEdge edge{a, b, ground_length(a, b)};
  const double error_m = edge_tolerance_ * geo::distance_m(a, b);
  return drive_time(edge, depart, latest, speed(drive),
                    [&](const motion::EdgePiece& piece) -> std::optional<motion::EdgeClosed> {
                      if (const auto closed = closed_then(edge, piece, error_m)) return closed;
                      if (below_ice && !ice()->may_transit_along(edge, piece))
                        return motion::EdgeClosed::under_ice;
                      return std::nullopt;
                    });
}

std::optional<motion::EdgeClosed> Sea::closed_then(const motion::PlaneEdge& edge,
                                                   const motion::EdgePiece& piece, double error_m) const {
  if (timed_zones_.forbid(edge, piece)) return motion::EdgeClosed::in_zone;
  if (!icebergs().standing() && icebergs().touched(edge, piece, error_m)) return motion::EdgeClosed::obstacle;
  return std::nullopt;
}

tl::expected<core::Seconds, motion::EdgeClosed> Sea::leg_time_without_timed_closures(
    geo::PlanePoint a, geo::PlanePoint b, core::Seconds depart, core::Seconds latest) const {
  if (const auto closed = closed_between(a, b)) return tl::unexpected(*closed);
  return drive_time({a, b, ground_length(a, b)}, depart, latest, speed(drives_.front()),
                    motion::VisitNoPiece{});
}

std::vector<motion::EvenMove> Sea::drive(geo::PlanePoint a, geo::PlanePoint b, core::Seconds depart,
                                         vehicle::Drive drive) const {
  std::vector<motion::EvenMove> moves;
  const motion::PlaneEdge edge{a, b, ground_length(a, b)};
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

std::optional<core::Seconds> Sea::first_clear_departure(geo::PlanePoint a, geo::PlanePoint b,
                                                        core::Seconds duration, core::Seconds depart,
                                                        core::Seconds latest) const {
  constexpr core::Seconds first_step{60.0};  // after a zone forbids the leg; the step doubles each time
  constexpr core::Seconds longest_step{900.0};
  constexpr core::Seconds close_enough{5.0};
  const auto forbidden = [&](core::Seconds leaves) {
    return timed_zones_.forbid(a, b, {leaves, leaves + duration});
  };
  while (depart <= latest) {
    if (!icebergs().standing()) {
      const auto clear = icebergs().first_clear(a, b, duration, depart, latest);
      if (!clear) return std::nullopt;
      depart = *clear;
    }
    if (!forbidden(depart)) return depart;
    core::Seconds closed = depart;
    core::Seconds open = depart + first_step;
    for (core::Seconds step = first_step; forbidden(open);) {
      if (open > latest) return std::nullopt;
      step = std::min(2.0 * step, longest_step);
      closed = open;
      open += step;
    }
    while (open - closed > close_enough) {
      const core::Seconds middle = 0.5 * (closed + open);
      (forbidden(middle) ? closed : open) = middle;
    }
    depart = open;
  }
  return std::nullopt;
}

std::vector<TimeSpan> Sea::closed_times(geo::PlanePoint point) const {
  std::vector<TimeSpan> closed = closed_times_by_zones(point);
  const std::vector<TimeSpan> by_icebergs = closed_times_by_icebergs(point);
  closed.insert(closed.end(), by_icebergs.begin(), by_icebergs.end());
  return joined(std::move(closed));
}

tl::expected<core::Seconds, motion::EdgeClosed> Sea::drive_time_back(const motion::PlaneEdge& edge,
                                                                     core::Seconds arrive,
                                                                     core::Seconds earliest) const {
  if (!currents_) return edge.ground_length / through_water();
  return motion::edge_time_back(edge, arrive, through_water(), *currents_, accuracy_, earliest);
}

tl::expected<core::Seconds, motion::EdgeClosed> Sea::leg_time_back(geo::PlanePoint a, geo::PlanePoint b,
                                                                   core::Seconds arrive,
                                                                   core::Seconds earliest) const {
  if (const auto closed = closed_between(a, b)) return tl::unexpected(*closed);
  const auto time = drive_time_back({a, b, ground_length(a, b)}, arrive, earliest);
  const bool below_ice = ice() && ice()->may_be_dense_along(a, b);
  if (!time || !(has_timed_closures() || below_ice)) return time;
  // Timed closures and the room below the ice are tested along the drive itself.
  const auto forwards = leg_time(a, b, arrive - *time);
  if (!forwards) return tl::unexpected(forwards.error());
  return time;
}

tl::expected<core::Seconds, motion::EdgeClosed> Sea::leg_time_back_without_timed_closures(
    geo::PlanePoint a, geo::PlanePoint b, core::Seconds arrive, core::Seconds earliest) const {
  if (const auto closed = closed_between(a, b)) return tl::unexpected(*closed);
  return drive_time_back({a, b, ground_length(a, b)}, arrive, earliest);
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
  if (!ice() && !overhead_.bounds_surfacing()) {
    return leg_time(a, b, depart, never, drive).map([](core::Seconds time) {
      return Leg{time, core::Seconds{0.0}};
    });
  }
  if (const auto closed = closed_between(a, b)) return tl::unexpected(*closed);
  const motion::PlaneEdge edge{a, b, ground_length(a, b)};
  SurfacingWatch watch{overhead_, edge, since_surfacing};
  const double error_m = edge_tolerance_ * geo::distance_m(a, b);
  const auto time = drive_time(edge, depart, never, speed(drive),
                               [&](const motion::EdgePiece& piece) -> std::optional<motion::EdgeClosed> {
                                 if (const auto closed = closed_then(edge, piece, error_m)) return closed;
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
  if (const auto closed = closed_between(a, b)) return tl::unexpected(*closed);
  const motion::PlaneEdge edge{a, b, ground_length(a, b)};
  const double error_m = edge_tolerance_ * geo::distance_m(a, b);
  const bool below_ice = ice() && ice()->may_be_dense_along(a, b);
  std::optional<SurfacingWatch> watch;
  if (overhead_.bounds_surfacing()) watch.emplace(overhead_, edge, since_surfacing);
  EnergyMeter meter{energy_, overhead_, edge, depart, drive, dives};
  const auto time = drive_time(edge, depart, latest, speed(drive),
                               [&](const motion::EdgePiece& piece) -> std::optional<motion::EdgeClosed> {
                                 if (const auto closed = closed_then(edge, piece, error_m)) return closed;
                                 if (watch) {
                                   if (const auto closed = (*watch)(piece)) return closed;
                                 } else if (below_ice && !ice()->may_transit_along(edge, piece)) {
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
  if (const auto closed = closed_between(a, b)) return tl::unexpected(*closed);
  const motion::PlaneEdge edge{a, b, ground_length(a, b)};
  const auto time = drive_time_back(edge, arrive, earliest);
  if (!time) return tl::unexpected(time.error());
  const core::Seconds depart = arrive - *time;
  SurfacingOutlook outlook{overhead_, edge, depart};
  const double error_m = edge_tolerance_ * geo::distance_m(a, b);
  const auto forwards = drive_time(edge, depart, core::Seconds{INFINITY}, through_water(),
                                   [&](const motion::EdgePiece& piece) -> std::optional<motion::EdgeClosed> {
                                     if (const auto closed = closed_then(edge, piece, error_m)) return closed;
                                     return outlook(piece);
                                   });
  if (!forwards) return tl::unexpected(forwards.error());
  return outlook.until_surfacing(until_surfacing).map([&](core::Seconds until) {
    return LegBack{*time, until};
  });
}

core::Seconds Sea::least_time_to_opening(geo::PlanePoint point) const {
  const core::Metres way = ice() ? ice()->least_way_to_opening(point) : core::Metres{0.0};
  return core::Seconds{least_slowness_s_m_ * way.value / largest_scale_};
}

std::vector<double> Sea::least_times_to_opening_s(const std::vector<geo::PlanePoint>& points,
                                                  core::Seconds from, core::Seconds until) const {
  std::vector<double> times_s(points.size(), 0.0);
  if (!ice()) return times_s;
  const std::vector<core::Metres> ways = ice()->least_ways_to_opening(points, from, until);
  for (std::size_t i = 0; i < ways.size(); ++i)
    times_s[i] = least_slowness_s_m_ * ways[i].value / largest_scale_;
  return times_s;
}

std::vector<Sea::Passage> Sea::passages(geo::PlanePoint a, geo::PlanePoint b, core::Seconds depart,
                                        core::Metres step, vehicle::Drive drive) const {
  std::vector<Passage> result;
  const motion::PlaneEdge edge{a, b, ground_length(a, b)};
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

bool Sea::currents_known_to_end(geo::PlanePoint point, core::Seconds from) const {
  constexpr int looks = 64;
  if (!currents_) return true;
  const core::Seconds end = currents_->end().value_or(from);
  for (int i = 0; i <= looks; ++i) {
    const double share = static_cast<double>(i) / looks;
    if (!(*currents_)(point, from + share * std::max(core::Seconds{0.0}, end - from))) return false;
  }
  return true;
}

core::Seconds Sea::least_time(geo::PlanePoint a, geo::PlanePoint b, vehicle::Drive drive) const {
  const core::MetresPerSecond astern{currents_ ? currents_->strongest().value : 0.0};
  const core::Metres least_length{geo::distance_m(a, b) / largest_scale_};
  return (1.0 - edge_tolerance_) * (least_length / (speed(drive) + astern));
}

core::Seconds Sea::least_time(core::Metres length, core::MetresPerSecond astern) const {
  const core::MetresPerSecond fastest = fastest_through_water_ + std::min(astern, currents_->strongest());
  if (fastest.value <= 0.0) return core::Seconds{INFINITY};
  return (1.0 - edge_tolerance_) * ((1.0 / largest_scale_) * length / fastest);
}

bool Sea::is_steady() const {
  // Ice changes with time; even a single ice map is valid for some days only.
  const bool ice_matters = ice() && (ice()->has_dense_ice() || overhead_.bounds_surfacing());
  return !has_timed_closures() && (!currents_ || !currents_->end()) && !ice_matters;
}

core::Seconds Sea::least_time(geo::PlanePoint a, geo::PlanePoint b) const {
  return core::Seconds{least_slowness_s_m_ * geo::distance_m(a, b) / largest_scale_};
}

}  // namespace floeplan::planning::cost

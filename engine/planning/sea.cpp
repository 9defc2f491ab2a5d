#include "engine/planning/sea.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace floeplan::planning {
namespace {

constexpr int scale_cells =
    64;  // a side: the scale is smooth, its error over 1/64 of an area far below the tolerance

std::optional<PlaneCurrents> lay_out(const ocean::Environment& environment, const PlanRequest& request,
                                     const geo::LocalProjection& projection, const PlaneBox& area,
                                     const std::stop_token& stop) {
  if (!environment.currents) return std::nullopt;
  return PlaneCurrents{*environment.currents,
                       environment.steady_currents,
                       FlownDepths{request.vehicle.dive_limits(), environment.bathymetry},
                       projection,
                       area,
                       request.depart,
                       stop};
}

/// A step no longer than a cell of the data, nor than the time between two of its slices.
motion::EdgeAccuracy accuracy(const std::optional<PlaneCurrents>& currents, const PlanRequest& request) {
  motion::EdgeAccuracy result{.relative_tolerance = request.edge_tolerance};
  if (!currents) return result;
  result.longest_step = currents->spacing();
  if (const auto time_step = currents->time_step()) result.longest_duration = *time_step;
  return result;
}

/// A glider comes to the surface between its dives.
ZoneRules zone_rules(const ocean::Environment& environment, const PlanRequest& request) {
  std::vector<ocean::Zone> zones = environment.zones;
  zones.insert(zones.end(), request.zones.begin(), request.zones.end());
  return sort_zones(zones, {core::Metres{0.0}, request.vehicle.dive_depth});
}

}  // namespace

Sea::Sea(const ocean::Environment& environment, const PlanRequest& request,
         const geo::LocalProjection& projection, const PlaneBox& area, core::Metres cell,
         const std::stop_token& stop)
    : Sea{environment, request, zone_rules(environment, request), projection, area, cell, stop} {}

Sea::Sea(const ocean::Environment& environment, const PlanRequest& request, ZoneRules zones,
         const geo::LocalProjection& projection, const PlaneBox& area, core::Metres cell,
         const std::stop_token& stop)
    : projection_{projection},
      area_{area},
      through_water_{request.vehicle.speed_through_water},
      safety_{environment, request.vehicle.least_water(), std::move(zones.standing), projection, area, cell,
              stop},
      timed_zones_{zones.timed, projection, request.depart},
      icebergs_{environment.icebergs, request.iceberg_margin, projection},
      currents_{lay_out(environment, request, projection, area, stop)} {
  accuracy_ = accuracy(currents_, request);
  for (int iy = 0; iy <= scale_cells; ++iy) {
    for (int ix = 0; ix <= scale_cells; ++ix) {
      const geo::PlanePoint point{area.low.x_m + area.width_m() * ix / scale_cells,
                                  area.low.y_m + area.height_m() * iy / scale_cells};
      scales_.push_back(projection_.at(projection_.to_lon_lat(point)).scale);
    }
  }
  largest_scale_ = std::ranges::max(scales_);
  const double fastest = through_water_.value + (currents_ ? currents_->strongest().value : 0.0);
  // A hair below the bound, because integrated times carry the tolerance as an error.
  least_slowness_s_m_ = (1.0 - request.edge_tolerance) / fastest;
}

double Sea::scale_at(geo::PlanePoint point) const {
  const double x = std::clamp((point.x_m - area_.low.x_m) / area_.width_m(), 0.0, 1.0) * scale_cells;
  const double y = std::clamp((point.y_m - area_.low.y_m) / area_.height_m(), 0.0, 1.0) * scale_cells;
  const int ix = std::min(static_cast<int>(x), scale_cells - 1);
  const int iy = std::min(static_cast<int>(y), scale_cells - 1);
  const double fx = x - ix;
  const double fy = y - iy;
  const double* row = scales_.data() + iy * (scale_cells + 1) + ix;
  const double south = row[0] + fx * (row[1] - row[0]);
  const double north = row[scale_cells + 1] + fx * (row[scale_cells + 2] - row[scale_cells + 1]);
  return south + fy * (north - south);
}

core::Metres Sea::ground_length(geo::PlanePoint a, geo::PlanePoint b) const {
  // Simpson's rule for the mean of 1/scale along the line.
  const geo::PlanePoint middle{0.5 * (a.x_m + b.x_m), 0.5 * (a.y_m + b.y_m)};
  const double mean = (1.0 / scale_at(a) + 4.0 / scale_at(middle) + 1.0 / scale_at(b)) / 6.0;
  return core::Metres{mean * std::hypot(b.x_m - a.x_m, b.y_m - a.y_m)};
}

std::optional<motion::EdgeClosed> Sea::closed_between(geo::PlanePoint a, geo::PlanePoint b) const {
  if (const auto closed = safety_.closed_between(a, b)) return closed;
  if (icebergs_.crosses(a, b)) return motion::EdgeClosed::obstacle;
  return std::nullopt;
}

tl::expected<core::Seconds, motion::EdgeClosed> Sea::leg_time(geo::PlanePoint a, geo::PlanePoint b,
                                                              core::Seconds depart,
                                                              core::Seconds latest) const {
  if (const auto closed = closed_between(a, b)) return tl::unexpected(*closed);
  const motion::PlaneEdge edge{a, b, ground_length(a, b)};
  const auto obey_zones = [&](const motion::EdgePiece& piece) -> std::optional<motion::EdgeClosed> {
    if (timed_zones_.forbid(edge, piece)) return motion::EdgeClosed::in_zone;
    return std::nullopt;
  };
  if (!currents_) {
    const core::Seconds time = edge.ground_length / through_water_;
    if (timed_zones_.forbid(a, b, {depart, depart + time}))
      return tl::unexpected(motion::EdgeClosed::in_zone);
    return time;
  }
  const auto integrate = [&](const auto& visit_piece) {
    if (currents_->has_lines())
      return motion::edge_time(edge, depart, through_water_, *currents_, accuracy_, latest, visit_piece);
    const auto point_by_point = [this](geo::PlanePoint point, core::Seconds time) {
      return (*currents_)(point, time);
    };
    return motion::edge_time(edge, depart, through_water_, point_by_point, accuracy_, latest, visit_piece);
  };
  return timed_zones_.empty() ? integrate(motion::VisitNoPiece{}) : integrate(obey_zones);
}

bool Sea::currents_known(geo::PlanePoint point, core::Seconds time) const {
  return !currents_ || (*currents_)(point, time).has_value();
}

core::Seconds Sea::least_time(geo::PlanePoint a, geo::PlanePoint b) const {
  return core::Seconds{least_slowness_s_m_ * std::hypot(b.x_m - a.x_m, b.y_m - a.y_m) / largest_scale_};
}

}  // namespace floeplan::planning

#include "tests/engine/avoidance/light/body.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace floeplan::support {
namespace {

/// Turns into the axes of the body and measures in its semi-axes.
SeaPoint in_axes(const PlacedBody& placed, const SeaPoint& v, double margin_m) {
  const SeaPoint& half = placed.body->half_axes;
  return {(v.east_m * placed.sin_bearing + v.north_m * placed.cos_bearing) / (half.east_m + margin_m),
          (v.east_m * placed.cos_bearing - v.north_m * placed.sin_bearing) / (half.north_m + margin_m),
          v.depth_m / (half.depth_m + margin_m)};
}

SeaPoint minus(const SeaPoint& a, const SeaPoint& b) {
  return {a.east_m - b.east_m, a.north_m - b.north_m, a.depth_m - b.depth_m};
}

double dot(const SeaPoint& a, const SeaPoint& b) {
  return a.east_m * b.east_m + a.north_m * b.north_m + a.depth_m * b.depth_m;
}

std::optional<double> into_ball(const SeaPoint& from, const SeaPoint& along) {
  const double a = dot(along, along);
  const double b = dot(from, along);
  const double discriminant = b * b - a * (dot(from, from) - 1.0);
  if (discriminant < 0.0) return std::nullopt;
  const double t = (-b - std::sqrt(discriminant)) / a;
  return t > 0.0 ? std::optional{t} : std::nullopt;
}

std::optional<double> into_cube(const SeaPoint& from, const SeaPoint& along) {
  double in = 0.0;
  double out = std::numeric_limits<double>::infinity();
  for (const auto& [p, v] : {std::array{from.east_m, along.east_m}, std::array{from.north_m, along.north_m},
                             std::array{from.depth_m, along.depth_m}}) {
    if (v == 0.0) {
      if (std::abs(p) > 1.0) return std::nullopt;
      continue;
    }
    in = std::max(in, std::min((-1.0 - p) / v, (1.0 - p) / v));
    out = std::min(out, std::max((-1.0 - p) / v, (1.0 - p) / v));
  }
  return in > 0.0 && in <= out ? std::optional{in} : std::nullopt;
}

}  // namespace

PlacedBody placed_at(const Body& body, double time_s, geo::PlanePoint carried) {
  const double bearing = body.bearing_rad + body.turn_rad_s * time_s;
  PlacedBody placed{&body, body.centre, std::sin(bearing), std::cos(bearing)};
  if (body.is_fixed) return placed;
  placed.centre.east_m += body.drift.x_m_s * time_s + carried.x_m;
  placed.centre.north_m += body.drift.y_m_s * time_s + carried.y_m;
  return placed;
}

double reach_m(const Body& body) { return std::hypot(body.half_axes.east_m, body.half_axes.north_m); }

bool is_inside(const PlacedBody& placed, const SeaPoint& point, double margin_m) {
  const SeaPoint p = in_axes(placed, minus(point, placed.centre), margin_m);
  if (placed.body->shape == Body::Shape::ellipsoid) return dot(p, p) <= 1.0;
  return std::abs(p.east_m) <= 1.0 && std::abs(p.north_m) <= 1.0 && std::abs(p.depth_m) <= 1.0;
}

std::optional<double> first_hit(const PlacedBody& placed, const SeaPoint& from, const SeaPoint& direction) {
  const SeaPoint p = in_axes(placed, minus(from, placed.centre), 0.0);
  const SeaPoint v = in_axes(placed, direction, 0.0);
  return placed.body->shape == Body::Shape::ellipsoid ? into_ball(p, v) : into_cube(p, v);
}

}  // namespace floeplan::support

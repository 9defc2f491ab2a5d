#include "engine/geo/tangent_plane.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace floeplan::geo {
namespace {

constexpr double radians_per_degree = std::numbers::pi / 180.0;
constexpr double mean_radius_m = 6371008.8;  // Moritz 2000, Geodetic Reference System 1980, J. Geodesy 74

UnitVector normalised(double x, double y, double z) {
  const double length = std::sqrt(x * x + y * y + z * z);
  return {x / length, y / length, z / length};
}

UnitVector cross(UnitVector a, UnitVector b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

}  // namespace

UnitVector unit_vector(LonLat place) {
  const double lon = place.lon_deg * radians_per_degree;
  const double lat = place.lat_deg * radians_per_degree;
  return {std::cos(lat) * std::cos(lon), std::cos(lat) * std::sin(lon), std::sin(lat)};
}

LonLat lon_lat(UnitVector direction) {
  return {std::atan2(direction.y, direction.x) / radians_per_degree,
          std::atan2(direction.z, std::hypot(direction.x, direction.y)) / radians_per_degree};
}

double dot(UnitVector a, UnitVector b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

LonLat midpoint(LonLat a, LonLat b) {
  const UnitVector u = unit_vector(a);
  const UnitVector v = unit_vector(b);
  return lon_lat(normalised(u.x + v.x, u.y + v.y, u.z + v.z));
}

double sphere_distance_m(LonLat a, LonLat b) {
  const UnitVector u = unit_vector(a);
  const UnitVector v = unit_vector(b);
  const double chord = std::hypot(u.x - v.x, u.y - v.y, u.z - v.z);
  return 2.0 * mean_radius_m * std::asin(std::min(1.0, chord / 2.0));
}

std::optional<double> direction_at(LonLat at, LonLat from, LonLat to) {
  const UnitVector u = unit_vector(from);
  const UnitVector v = unit_vector(to);
  const double dx = v.x - u.x;
  const double dy = v.y - u.y;
  const double dz = v.z - u.z;
  const double lon = at.lon_deg * radians_per_degree;
  const double lat = at.lat_deg * radians_per_degree;
  const double east = -std::sin(lon) * dx + std::cos(lon) * dy;
  const double north = -std::sin(lat) * (std::cos(lon) * dx + std::sin(lon) * dy) + std::cos(lat) * dz;
  if (std::hypot(east, north) < 1e-12) return std::nullopt;
  return std::atan2(north, east);
}

double convergence(LonLat from, LonLat to) {
  const double half_turn = 0.5 * longitude_difference(from.lon_deg, to.lon_deg) * radians_per_degree;
  const double mean_lat = 0.5 * (from.lat_deg + to.lat_deg) * radians_per_degree;
  const double half_rise = 0.5 * (to.lat_deg - from.lat_deg) * radians_per_degree;
  return 2.0 *
         std::atan2(std::sin(half_turn) * std::sin(mean_lat), std::cos(half_turn) * std::cos(half_rise));
}

TangentPlane::TangentPlane(UnitVector at) : at_{at} {
  const UnitVector axis = std::abs(at.z) < 0.9 ? UnitVector{0.0, 0.0, 1.0} : UnitVector{1.0, 0.0, 0.0};
  const UnitVector side = cross(axis, at);
  e1_ = normalised(side.x, side.y, side.z);
  e2_ = cross(at, e1_);
}

TangentPlane::Point TangentPlane::project(UnitVector direction) const {
  const double depth = dot(at_, direction);
  return {dot(e1_, direction) / depth, dot(e2_, direction) / depth};
}

}  // namespace floeplan::geo

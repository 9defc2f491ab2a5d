#include "engine/geo/bounding_box.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <utility>
#include <vector>

namespace floeplan::geo {
namespace {

constexpr double metres_per_degree = 110'574.0;  // shortest degree of latitude on WGS84 (at the equator)

double eastward(double from_deg, double to_deg) {
  const double difference = longitude_difference(from_deg, to_deg);
  return difference < 0.0 ? difference + 360.0 : difference;
}

std::string degrees_text(double degrees, char positive, char negative) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.4g° %c", std::abs(degrees), degrees < 0.0 ? negative : positive);
  return text.data();
}

}  // namespace

double width_deg(const BoundingBox& box) {
  if (box.east_deg - box.west_deg >= 360.0) return 360.0;
  return eastward(box.west_deg, box.east_deg);
}

bool contains(const BoundingBox& box, LonLat place) {
  // The longitude is wrapped first, as for the box's edges, so that rounding does not exclude a place on an
  // edge.
  return place.lat_deg >= box.south_deg && place.lat_deg <= box.north_deg &&
         eastward(box.west_deg, wrap_longitude(place.lon_deg)) <= width_deg(box);
}

bool intersects(const BoundingBox& a, const BoundingBox& b) {
  if (a.south_deg > b.north_deg || b.south_deg > a.north_deg) return false;
  return eastward(a.west_deg, b.west_deg) <= width_deg(a) || eastward(b.west_deg, a.west_deg) <= width_deg(b);
}

BoundingBox bounding_box(std::span<const LonLat> places) {
  if (places.empty()) throw std::invalid_argument{"bounding_box needs at least one place"};

  BoundingBox box{0.0, 90.0, 0.0, -90.0};
  std::vector<double> longitudes;
  longitudes.reserve(places.size());
  for (const LonLat place : places) {
    box.south_deg = std::min(box.south_deg, place.lat_deg);
    box.north_deg = std::max(box.north_deg, place.lat_deg);
    longitudes.push_back(wrap_longitude(place.lon_deg));
  }

  // The box is the circle of longitudes without its widest empty gap.
  std::ranges::sort(longitudes);
  double widest_gap = longitudes.front() + 360.0 - longitudes.back();
  box.west_deg = longitudes.front();
  box.east_deg = longitudes.back();
  for (std::size_t i = 1; i < longitudes.size(); ++i) {
    const double gap = longitudes[i] - longitudes[i - 1];
    if (gap > widest_gap) {
      widest_gap = gap;
      box.west_deg = longitudes[i];
      box.east_deg = longitudes[i - 1];
    }
  }
  return box;
}

BoundingBox grown(const BoundingBox& box, core::Metres margin) {
  const double north_south = margin.value / metres_per_degree;
  BoundingBox result{box.west_deg, std::max(-90.0, box.south_deg - north_south), box.east_deg,
                     std::min(90.0, box.north_deg + north_south)};

  const double steepest = std::max(std::abs(result.south_deg), std::abs(result.north_deg));
  const double east_west = north_south / std::max(1e-9, std::cos(core::degrees_to_radians(steepest)));
  if (steepest >= 90.0 || width_deg(box) + 2.0 * east_west >= 360.0) {
    result.west_deg = -180.0;
    result.east_deg = 180.0;
    return result;
  }
  result.west_deg = wrap_longitude(box.west_deg - east_west);
  result.east_deg = wrap_longitude(box.east_deg + east_west);
  return result;
}

BoundingBox united(const BoundingBox& a, const BoundingBox& b) {
  // Two candidates: from the western edge of one box to the eastern edge that is further, for each box.
  const auto from_west_of = [](const BoundingBox& first, const BoundingBox& second) {
    const double to_second = eastward(first.west_deg, second.west_deg) + width_deg(second);
    const double width = std::max(width_deg(first), to_second);
    return std::pair{
        width, BoundingBox{.west_deg = first.west_deg,
                           .east_deg = to_second > width_deg(first) ? second.east_deg : first.east_deg}};
  };
  const auto [width_a, begins_as_a] = from_west_of(a, b);
  const auto [width_b, begins_as_b] = from_west_of(b, a);
  BoundingBox result = width_a <= width_b ? begins_as_a : begins_as_b;
  if (std::min(width_a, width_b) >= 360.0) result = {.west_deg = -180.0, .east_deg = 180.0};
  result.south_deg = std::min(a.south_deg, b.south_deg);
  result.north_deg = std::max(a.north_deg, b.north_deg);
  return result;
}

LonLat nearest_place(const BoundingBox& box, LonLat place) {
  const double lat_deg = std::clamp(place.lat_deg, box.south_deg, box.north_deg);
  const double beyond_west = eastward(box.west_deg, wrap_longitude(place.lon_deg));
  if (beyond_west <= width_deg(box)) return {place.lon_deg, lat_deg};
  const bool west_is_nearer = 360.0 - beyond_west < beyond_west - width_deg(box);
  return {west_is_nearer ? box.west_deg : box.east_deg, lat_deg};
}

std::string bounds_text(const BoundingBox& box) {
  const auto extent = [](const std::string& from, const std::string& to) {
    return from == to ? from : from + " to " + to;
  };
  return extent(degrees_text(box.west_deg, 'E', 'W'), degrees_text(box.east_deg, 'E', 'W')) + ", " +
         extent(degrees_text(box.south_deg, 'N', 'S'), degrees_text(box.north_deg, 'N', 'S'));
}

BoundingBox on_lattice(const BoundingBox& box, double step_deg) {
  const auto down = [step_deg](double deg) { return step_deg * std::floor(deg / step_deg); };
  const auto up = [step_deg](double deg) { return step_deg * std::ceil(deg / step_deg); };
  const double west_deg = down(box.west_deg);
  const double east_deg = up(box.west_deg + width_deg(box));
  if (east_deg - west_deg >= 360.0) return {-180.0, down(box.south_deg), 180.0, up(box.north_deg)};
  return {wrap_longitude(west_deg), down(box.south_deg), wrap_longitude(east_deg), up(box.north_deg)};
}

}  // namespace floeplan::geo

#include "engine/geo/bounding_box.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace floeplan::geo {
namespace {

constexpr double metres_per_degree = 110'574.0;  // shortest degree of latitude on WGS84, at the equator

double eastward(double from_deg, double to_deg) {
  const double difference = longitude_difference(from_deg, to_deg);
  return difference < 0.0 ? difference + 360.0 : difference;
}

}  // namespace

double width_deg(const BoundingBox& box) {
  if (box.east_deg - box.west_deg >= 360.0) return 360.0;
  return eastward(box.west_deg, box.east_deg);
}

bool contains(const BoundingBox& box, LonLat place) {
  // Wrapped first, as the edges of a box of places are: a place on an edge is then not lost to rounding.
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

  // The box is what remains of the circle after its widest empty gap is taken out.
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

}  // namespace floeplan::geo

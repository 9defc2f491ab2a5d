#include "engine/geo/grid_frame.hpp"

#include <GeographicLib/Constants.hpp>
#include <GeographicLib/PolarStereographic.hpp>
#include <GeographicLib/TransverseMercator.hpp>
#include <cmath>
#include <iomanip>
#include <limits>
#include <locale>
#include <sstream>

namespace floeplan::geo {
namespace {

template <class... Fs>
struct Overloaded : Fs... {
  using Fs::operator()...;
};
template <class... Fs>
Overloaded(Fs...) -> Overloaded<Fs...>;

GeographicLib::PolarStereographic formula(const PolarStereographicFrame& frame) {
  GeographicLib::PolarStereographic result{frame.ellipsoid.semi_major_m,
                                           1.0 / frame.ellipsoid.inverse_flattening, 1.0};
  result.SetScale(std::abs(frame.lat_ts_deg), 1.0);
  return result;
}

GeographicLib::TransverseMercator formula(const TransverseMercatorFrame& frame) {
  return {GeographicLib::Constants::WGS84_a(), GeographicLib::Constants::WGS84_f(), frame.scale_0};
}

/// Northing of the frame's origin above the equator, from which the formulas count.
double origin_northing(const TransverseMercatorFrame& frame) {
  double x = 0.0;
  double y = 0.0;
  formula(frame).Forward(0.0, frame.lat_0_deg, 0.0, x, y);
  return y;
}

}  // namespace

GridPoint to_grid(const GridFrame& frame, LonLat place) {
  return std::visit(
      Overloaded{
          [&](const GeographicFrame&) { return GridPoint{place.lon_deg, place.lat_deg}; },
          [&](const PolarStereographicFrame& polar) {
            GridPoint point;
            formula(polar).Forward(polar.north, place.lat_deg,
                                   longitude_difference(polar.lon_0_deg, place.lon_deg), point.x, point.y);
            return GridPoint{point.x + polar.false_easting_m, point.y + polar.false_northing_m};
          },
          [&](const TransverseMercatorFrame& mercator) {
            GridPoint point;
            formula(mercator).Forward(mercator.lon_0_deg, place.lat_deg, place.lon_deg, point.x, point.y);
            return GridPoint{point.x + mercator.false_easting_m,
                             point.y - origin_northing(mercator) + mercator.false_northing_m};
          }},
      frame);
}

LonLat to_lon_lat(const GridFrame& frame, GridPoint point) {
  return std::visit(
      Overloaded{[&](const GeographicFrame&) { return LonLat{wrap_longitude(point.x), point.y}; },
                 [&](const PolarStereographicFrame& polar) {
                   LonLat place;
                   formula(polar).Reverse(polar.north, point.x - polar.false_easting_m,
                                          point.y - polar.false_northing_m, place.lat_deg, place.lon_deg);
                   place.lon_deg = wrap_longitude(place.lon_deg + polar.lon_0_deg);
                   return place;
                 },
                 [&](const TransverseMercatorFrame& mercator) {
                   LonLat place;
                   formula(mercator).Reverse(mercator.lon_0_deg, point.x - mercator.false_easting_m,
                                             point.y - mercator.false_northing_m + origin_northing(mercator),
                                             place.lat_deg, place.lon_deg);
                   place.lon_deg = wrap_longitude(place.lon_deg);
                   return place;
                 }},
      frame);
}

std::string frame_text(const GridFrame& frame) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << std::setprecision(std::numeric_limits<double>::max_digits10);
  std::visit(Overloaded{[&](const GeographicFrame&) { text << "geographic"; },
                        [&](const PolarStereographicFrame& polar) {
                          text << "polar_stereographic " << (polar.north ? "north " : "south ")
                               << polar.lat_ts_deg << ' ' << polar.lon_0_deg << ' ' << polar.false_easting_m
                               << ' ' << polar.false_northing_m;
                          if (polar.ellipsoid == wgs84) return;
                          text << ' ' << polar.ellipsoid.semi_major_m << ' '
                               << polar.ellipsoid.inverse_flattening;
                        },
                        [&](const TransverseMercatorFrame& mercator) {
                          text << "transverse_mercator " << mercator.lon_0_deg << ' ' << mercator.lat_0_deg
                               << ' ' << mercator.scale_0 << ' ' << mercator.false_easting_m << ' '
                               << mercator.false_northing_m;
                        }},
             frame);
  return text.str();
}

std::optional<GridFrame> parse_frame(std::string_view text) {
  std::istringstream words{std::string{text}};
  words.imbue(std::locale::classic());
  std::string name;
  words >> name;
  if (name == "geographic") return GeographicFrame{};
  if (name == "polar_stereographic") {
    PolarStereographicFrame polar;
    std::string pole;
    words >> pole >> polar.lat_ts_deg >> polar.lon_0_deg >> polar.false_easting_m >> polar.false_northing_m;
    if (!words || (pole != "north" && pole != "south")) return std::nullopt;
    polar.north = pole == "north";
    Ellipsoid ellipsoid;
    if (words >> ellipsoid.semi_major_m >> ellipsoid.inverse_flattening) polar.ellipsoid = ellipsoid;
    return polar;
  }
  if (name == "transverse_mercator") {
    TransverseMercatorFrame mercator;
    words >> mercator.lon_0_deg >> mercator.lat_0_deg >> mercator.scale_0 >> mercator.false_easting_m >>
        mercator.false_northing_m;
    if (!words) return std::nullopt;
    return mercator;
  }
  return std::nullopt;
}

}  // namespace floeplan::geo

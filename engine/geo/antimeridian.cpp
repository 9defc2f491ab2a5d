#include "engine/geo/antimeridian.hpp"

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/multi_polygon.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <cmath>
#include <utility>

namespace floeplan::geo {
namespace {

namespace bg = boost::geometry;
using ChartPoint = bg::model::d2::point_xy<double>;
using ChartPolygon = bg::model::polygon<ChartPoint, false, true>;  // counter-clockwise, closed
using ChartRing = ChartPolygon::ring_type;
using ChartPolygons = bg::model::multi_polygon<ChartPolygon>;
using ChartBox = bg::model::box<ChartPoint>;

/// The places of a ring with longitudes that run on without a jump, from the first within [-180, 180).
struct Unrolled {
  ChartRing places;   // open: the last does not repeat the first
  double turn_deg{};  // how far round the globe the ring goes: 0, or a turn east or west round a pole
};

/// On the antimeridian, or a whole number of turns from it, where only rounding keeps it from there: slivers so narrow
/// are more than cutting and joining can be trusted with.
double snapped(double lon_deg) {
  constexpr double rounding_deg = 1e-9;  // a tenth of a millimetre
  const double nearest_deg = 180.0 + 360.0 * std::round((lon_deg - 180.0) / 360.0);
  return std::abs(lon_deg - nearest_deg) < rounding_deg ? nearest_deg : lon_deg;
}

Unrolled unroll(const Ring& ring) {
  Unrolled result;
  double lon_deg = wrap_longitude(ring.front().lon_deg);
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (i > 0) lon_deg += longitude_difference(ring[i - 1].lon_deg, ring[i].lon_deg);
    result.places.emplace_back(snapped(lon_deg), ring[i].lat_deg);
  }
  const double back_deg = lon_deg + longitude_difference(ring.back().lon_deg, ring.front().lon_deg);
  const double turns = std::round((back_deg - result.places.front().x()) / 360.0);
  result.turn_deg = 360.0 * turns;
  return result;
}

/// A ring round a pole, cut open on the antimeridian and closed along the pole's parallel.
ChartRing closed_over_pole(const Unrolled& ring, double pole_deg) {
  const double end_deg = std::copysign(180.0, ring.turn_deg);
  const auto beyond = [&](const ChartPoint& place) {
    return end_deg > 0.0 ? place.x() >= 180.0 : place.x() < -180.0;
  };
  const auto& places = ring.places;
  const auto after = static_cast<std::size_t>(std::ranges::find_if(places, beyond) - places.begin());
  const ChartPoint& a = places[after - 1];  // the first place is not beyond
  const ChartPoint b = after < places.size()
                           ? places[after]
                           : ChartPoint{places.front().x() + ring.turn_deg, places.front().y()};
  const double lat_deg = a.y() + (end_deg - a.x()) / (b.x() - a.x()) * (b.y() - a.y());

  ChartRing result{{-end_deg, lat_deg}};
  for (std::size_t i = after; i < places.size(); ++i) {
    result.emplace_back(places[i].x() - ring.turn_deg, places[i].y());
  }
  result.insert(result.end(), places.begin(), places.begin() + static_cast<std::ptrdiff_t>(after));
  result.emplace_back(end_deg, lat_deg);
  // Neighbours less than half a turn apart: who reads the ring takes the short way between them.
  for (const double share : {1.0, 0.5, 0.0, -0.5, -1.0}) result.emplace_back(share * end_deg, pole_deg);
  return result;
}

/// The inside of a counter-clockwise ring: it lies on its left, to the north of one that runs eastwards.
ChartPolygon inside_of(const Ring& ring) {
  const Unrolled unrolled = unroll(ring);
  ChartPolygon result;
  result.outer() = unrolled.turn_deg == 0.0
                       ? unrolled.places
                       : closed_over_pole(unrolled, std::copysign(90.0, unrolled.turn_deg));
  result.outer().push_back(result.outer().front());
  bg::unique(result);
  return result;
}

bool fits_chart(const ChartRing& places) {
  return std::ranges::all_of(
      places, [](const ChartPoint& place) { return place.x() >= -180.0 && place.x() <= 180.0; });
}

ChartPolygons on_chart(const ChartPolygon& polygon) {
  ChartPolygons result;
  if (fits_chart(polygon.outer())) {
    result.push_back(polygon);
    return result;
  }
  for (const double turn_deg : {-360.0, 0.0, 360.0}) {
    const ChartBox chart{{turn_deg - 180.0, -90.0}, {turn_deg + 180.0, 90.0}};
    ChartPolygons pieces;
    bg::intersection(polygon, chart, pieces);
    for (ChartPolygon& piece : pieces) {
      for (ChartPoint& point : piece.outer()) point.x(point.x() - turn_deg);
      result.push_back(std::move(piece));
    }
  }
  return result;
}

bool fits_chart(const Ring& ring) {
  const Unrolled unrolled = unroll(ring);
  return unrolled.turn_deg == 0.0 && fits_chart(unrolled.places);
}

Ring to_ring(const ChartRing& ring) {
  Ring result;
  for (const ChartPoint& point : ring) result.push_back({point.x(), point.y()});
  result.pop_back();  // the last place joins the first
  return result;
}

Ring wrapped(Ring ring) {
  for (LonLat& place : ring) place.lon_deg = wrap_longitude(place.lon_deg);
  return ring;
}

}  // namespace

std::vector<Polygon> split_at_antimeridian(const Polygon& polygon) {
  if (fits_chart(polygon.outer)) {
    Polygon whole{.outer = wrapped(polygon.outer), .holes = {}};
    for (const Ring& hole : polygon.holes) whole.holes.push_back(wrapped(hole));
    return {whole};
  }
  ChartPolygons area = on_chart(inside_of(polygon.outer));
  for (Ring hole : polygon.holes) {
    std::ranges::reverse(hole);
    ChartPolygons rest;
    bg::difference(area, on_chart(inside_of(hole)), rest);
    area = std::move(rest);
  }
  std::vector<Polygon> pieces;
  for (const ChartPolygon& piece : area) {
    pieces.push_back({.outer = to_ring(piece.outer()), .holes = {}});
    for (const ChartRing& hole : piece.inners()) pieces.back().holes.push_back(to_ring(hole));
  }
  return pieces;
}

}  // namespace floeplan::geo

#include "engine/geo/antimeridian.hpp"

#include <geos_c.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <utility>

namespace floeplan::geo {
namespace {

struct ChartPoint {
  double x{};  // degrees of longitude; may exceed 180
  double y{};  // degrees of latitude

  bool operator==(const ChartPoint&) const = default;
};
using ChartRing = std::vector<ChartPoint>;

/// A ring whose longitudes continue without a jump; the first lies within [-180, 180).
struct Unrolled {
  ChartRing places;   // open: the last does not repeat the first
  double turn_deg{};  // total turn around the globe: 0, or 360 east (positive) or west around a pole
};

/// Moves longitudes that differ from the antimeridian only by rounding onto it. Cutting and joining would
/// leave unreliable slivers otherwise.
double snapped(double lon_deg) {
  constexpr double rounding_deg = 1e-9;  // a tenth of a millimetre on the ground
  const double nearest_deg = 180.0 + 360.0 * std::round((lon_deg - 180.0) / 360.0);
  return std::abs(lon_deg - nearest_deg) < rounding_deg ? nearest_deg : lon_deg;
}

Unrolled unroll(const Ring& ring) {
  Unrolled result;
  double lon_deg = snapped(wrap_longitude(ring.front().lon_deg));
  if (lon_deg == 180.0) lon_deg = -180.0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (i > 0) lon_deg += longitude_difference(ring[i - 1].lon_deg, ring[i].lon_deg);
    result.places.push_back({snapped(lon_deg), ring[i].lat_deg});
  }
  const double back_deg = lon_deg + longitude_difference(ring.back().lon_deg, ring.front().lon_deg);
  const double turns = std::round((back_deg - result.places.front().x) / 360.0);
  result.turn_deg = 360.0 * turns;
  return result;
}

/// A ring around a pole, cut along the antimeridian and closed along the pole's parallel.
ChartRing closed_over_pole(const Unrolled& ring, double pole_deg) {
  const double end_deg = std::copysign(180.0, ring.turn_deg);
  const auto beyond = [&](const ChartPoint& place) {
    return end_deg > 0.0 ? place.x >= 180.0 : place.x < -180.0;
  };
  const auto& places = ring.places;
  const auto after = static_cast<std::size_t>(std::ranges::find_if(places, beyond) - places.begin());
  const ChartPoint& a = places[after - 1];  // the first place is never beyond
  const ChartPoint b =
      after < places.size() ? places[after] : ChartPoint{places.front().x + ring.turn_deg, places.front().y};
  const double lat_deg = a.y + (end_deg - a.x) / (b.x - a.x) * (b.y - a.y);

  ChartRing result{{-end_deg, lat_deg}};
  for (std::size_t i = after; i < places.size(); ++i)
    result.push_back({places[i].x - ring.turn_deg, places[i].y});
  result.insert(result.end(), places.begin(), places.begin() + static_cast<std::ptrdiff_t>(after));
  result.push_back({end_deg, lat_deg});
  // Consecutive places are less than half a turn apart, because readers take the short way between them.
  for (const double share : {1.0, 0.5, 0.0, -0.5, -1.0}) result.push_back({share * end_deg, pole_deg});
  return result;
}

/// The closed outline of a counter-clockwise ring. Its inside lies on its left: north of the outline where
/// that runs eastwards.
ChartRing outline_of(const Ring& ring) {
  const Unrolled unrolled = unroll(ring);
  ChartRing result = unrolled.turn_deg == 0.0
                         ? unrolled.places
                         : closed_over_pole(unrolled, std::copysign(90.0, unrolled.turn_deg));
  result.push_back(result.front());
  const auto repeated = std::ranges::unique(result);
  result.erase(repeated.begin(), repeated.end());
  return result;
}

bool fits_chart(const ChartRing& places) {
  return std::ranges::all_of(places,
                             [](const ChartPoint& place) { return place.x >= -180.0 && place.x <= 180.0; });
}

/// Geometries of GEOS in their own context. Operations that GEOS cannot perform throw std::runtime_error.
class Shapes {
 public:
  struct Delete {
    GEOSContextHandle_t context;
    void operator()(GEOSGeometry* shape) const { GEOSGeom_destroy_r(context, shape); }
  };
  using Shape = std::unique_ptr<GEOSGeometry, Delete>;

  /// The area within a closed outline.
  [[nodiscard]] Shape within(const ChartRing& outline) const {
    const auto points = static_cast<unsigned>(outline.size());
    GEOSCoordSequence* const sequence =
        GEOSCoordSeq_copyFromBuffer_r(context_.get(), &outline.front().x, points, 0, 0);
    if (sequence == nullptr) fail();
    GEOSGeometry* const ring = GEOSGeom_createLinearRing_r(context_.get(), sequence);
    if (ring == nullptr) fail();
    return owned(GEOSGeom_createPolygon_r(context_.get(), ring, nullptr, 0));
  }
  [[nodiscard]] Shape shared_by(const Shape& a, const Shape& b) const {
    return owned(GEOSIntersection_r(context_.get(), a.get(), b.get()));
  }
  [[nodiscard]] Shape without(const Shape& area, const Shape& cut_off) const {
    return owned(GEOSDifference_r(context_.get(), area.get(), cut_off.get()));
  }
  [[nodiscard]] Shape united(const Shape& a, const Shape& b) const {
    return owned(GEOSUnion_r(context_.get(), a.get(), b.get()));
  }

  /// The polygons of a geometry. Lines and points, left where geometries only touch, are dropped.
  [[nodiscard]] std::vector<Polygon> polygons(const Shape& area) const {
    std::vector<Polygon> result;
    const int parts = GEOSGetNumGeometries_r(context_.get(), area.get());
    for (int i = 0; i < parts; ++i) {
      const GEOSGeometry* const part = GEOSGetGeometryN_r(context_.get(), area.get(), i);
      if (GEOSGeomTypeId_r(context_.get(), part) != GEOS_POLYGON || GEOSisEmpty_r(context_.get(), part) != 0)
        continue;
      Polygon polygon{.outer = ring_of(GEOSGetExteriorRing_r(context_.get(), part), true), .holes = {}};
      const int holes = GEOSGetNumInteriorRings_r(context_.get(), part);
      for (int k = 0; k < holes; ++k)
        polygon.holes.push_back(ring_of(GEOSGetInteriorRingN_r(context_.get(), part, k), false));
      result.push_back(std::move(polygon));
    }
    return result;
  }

 private:
  [[noreturn]] static void fail() {
    throw std::runtime_error{"a polygon could not be cut at the antimeridian"};
  }

  [[nodiscard]] Shape owned(GEOSGeometry* shape) const {
    if (shape == nullptr) fail();
    return Shape{shape, Delete{context_.get()}};
  }

  /// An open ring in the requested direction.
  [[nodiscard]] Ring ring_of(const GEOSGeometry* ring, bool counter_clockwise) const {
    const GEOSCoordSequence* const sequence = GEOSGeom_getCoordSeq_r(context_.get(), ring);
    unsigned points = 0;
    if (sequence == nullptr || GEOSCoordSeq_getSize_r(context_.get(), sequence, &points) == 0 || points == 0)
      fail();
    ChartRing places(points);
    char runs_counter_clockwise = 0;
    if (GEOSCoordSeq_copyToBuffer_r(context_.get(), sequence, &places.front().x, 0, 0) == 0 ||
        GEOSCoordSeq_isCCW_r(context_.get(), sequence, &runs_counter_clockwise) == 0)
      fail();
    if ((runs_counter_clockwise != 0) != counter_clockwise) std::ranges::reverse(places);
    places.pop_back();  // GEOS repeats the first place at the end
    Ring result;
    for (const ChartPoint& place : places) result.push_back({snapped(place.x), place.y});
    return result;
  }

  struct Finish {
    void operator()(GEOSContextHandle_HS* context) const { GEOS_finish_r(context); }
  };
  std::unique_ptr<GEOSContextHandle_HS, Finish> context_{GEOS_init_r()};
};
static_assert(sizeof(ChartPoint) == 2 * sizeof(double), "GEOS reads and writes them one after the other");

/// The area within the outline, with parts outside the chart moved by whole turns onto it.
Shapes::Shape on_chart(const Shapes& shapes, const ChartRing& outline) {
  if (fits_chart(outline)) return shapes.within(outline);
  const Shapes::Shape chart =
      shapes.within({{-180.0, -90.0}, {180.0, -90.0}, {180.0, 90.0}, {-180.0, 90.0}, {-180.0, -90.0}});
  const auto turned = [&](double turn_deg) {
    ChartRing moved = outline;
    for (ChartPoint& place : moved) place.x += turn_deg;
    return shapes.shared_by(shapes.within(moved), chart);
  };
  return shapes.united(shapes.united(turned(-360.0), turned(0.0)), turned(360.0));
}

bool fits_chart(const Ring& ring) {
  const Unrolled unrolled = unroll(ring);
  return unrolled.turn_deg == 0.0 && fits_chart(unrolled.places);
}

/// The ring with longitudes that do not jump between the chart's two edges.
Ring unrolled_ring(const Ring& ring) {
  Ring result;
  for (const ChartPoint& place : unroll(ring).places) result.push_back({place.x, place.y});
  return result;
}

}  // namespace

std::vector<Polygon> split_at_antimeridian(const Polygon& polygon) {
  if (fits_chart(polygon.outer)) {
    Polygon whole{.outer = unrolled_ring(polygon.outer), .holes = {}};
    for (const Ring& hole : polygon.holes) whole.holes.push_back(unrolled_ring(hole));
    return {whole};
  }
  const Shapes shapes;
  Shapes::Shape area = on_chart(shapes, outline_of(polygon.outer));
  for (Ring hole : polygon.holes) {
    std::ranges::reverse(hole);
    area = shapes.without(area, on_chart(shapes, outline_of(hole)));
  }
  return shapes.polygons(area);
}

}  // namespace floeplan::geo

#include "storage/ingest/formats/vector/polygon_shapes.hpp"

#include <ogr_geometry.h>
#include <ogr_spatialref.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/geo/geodesic.hpp"
#include "engine/geo/ring_turns.hpp"
#include "engine/messages/ingest_area_messages.hpp"
#include "storage/ingest/notation/crs_text.hpp"
#include "storage/ingest/notation/text.hpp"

namespace floeplan::ingest {
namespace {

constexpr double most_deviation_m = 10.0;  // chosen: far below the margins with which areas are drawn
constexpr int most_divisions = 12;         // of one edge, so at most 4096 parts
constexpr double pole_step_deg = 60.0;     // between added corners at a pole, which lies on all longitudes

geo::LonLat middle(geo::LonLat a, geo::LonLat b) {
  return {geo::wrap_longitude(a.lon_deg + 0.5 * geo::longitude_difference(a.lon_deg, b.lon_deg)),
          0.5 * (a.lat_deg + b.lat_deg)};
}

bool is_pole(double lat_deg) { return std::abs(lat_deg) == 90.0; }

/// Adds corners between two corners, at most 60 degrees of longitude apart; without the two themselves.
void add_way(geo::Ring& ring, geo::LonLat from, geo::LonLat to) {
  const double steps = std::ceil(std::abs(to.lon_deg - from.lon_deg) / pole_step_deg - 1e-9);
  for (double i = 1.0; i < steps; ++i)
    ring.push_back({from.lon_deg + (to.lon_deg - from.lon_deg) * i / steps,
                    from.lat_deg + (to.lat_deg - from.lat_deg) * i / steps});
}

/// Whether all corners lie on one meridian, and some are given 360 degrees from the first (-180 and 180, or 0
/// and 360). Such a ring encloses an area only if its edges lead around the Earth.
bool spans_the_globe(const OGRLineString& line) {
  bool leads_round = false;
  for (int i = 0; i < line.getNumPoints(); ++i) {
    const double apart_deg = std::abs(line.getX(i) - line.getX(0));
    if (apart_deg != 0.0 && apart_deg != 360.0) return false;
    leads_round = leads_round || apart_deg == 360.0;
  }
  return leads_round;
}

}  // namespace

void PolygonShapes::Release::operator()(OGRCoordinateTransformation* transformation) const {
  OGRCoordinateTransformation::DestroyCT(transformation);
}

PolygonShapes::PolygonShapes() = default;
PolygonShapes::PolygonShapes(PolygonShapes&&) noexcept = default;
PolygonShapes::~PolygonShapes() = default;

Checked<PolygonShapes> PolygonShapes::in(const OGRSpatialReference& crs) {
  OGRSpatialReference from{crs};
  OGRSpatialReference to;
  to.SetWellKnownGeogCS("WGS84");
  from.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  to.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  PolygonShapes shapes;
  shapes.straight_ = from.IsGeographic() != 0;
  shapes.to_wgs84_.reset(OGRCreateCoordinateTransformation(&from, &to));
  if (!shapes.to_wgs84_) {
    const char* const name = crs.GetName();
    return refuse(
        messages::ingest_area_message<"crs-not-convertible">(name != nullptr ? name : "without a name"));
  }
  return shapes;
}

Checked<geo::LonLat> PolygonShapes::place(double x, double y) const {
  if (!std::isfinite(x) || !std::isfinite(y))
    return refuse(messages::ingest_area_message<"corner-without-position">());
  if (to_wgs84_ && to_wgs84_->Transform(1, &x, &y) == 0)
    return refuse(messages::ingest_area_message<"corner-outside-crs">(number(x), number(y)));
  if (!std::isfinite(x) || !std::isfinite(y))
    return refuse(messages::ingest_area_message<"corner-without-position">());
  if (std::abs(y) > 90.0) return refuse(messages::ingest_area_message<"latitude-beyond-pole">(number(y, 12)));
  if (std::abs(x) > 360.0)
    return refuse(messages::ingest_area_message<"longitude-out-of-range">(number(x, 12)));
  return geo::LonLat{x, y};
}

Checked<bool> PolygonShapes::divide(double x0, double y0, geo::LonLat from, double x1, double y1,
                                    geo::LonLat to, int depth, geo::Ring& ring) const {
  const double x = 0.5 * (x0 + x1);
  const double y = 0.5 * (y0 + y1);
  const auto half_way = place(x, y);
  if (!half_way) return refuse(half_way.error());
  if (depth == 0 || geo::geodesic_between(*half_way, middle(from, to)).length.value <= most_deviation_m)
    return true;
  auto divided = divide(x0, y0, from, x, y, *half_way, depth - 1, ring);
  if (!divided) return divided;
  ring.push_back(*half_way);
  return divide(x, y, *half_way, x1, y1, to, depth - 1, ring);
}

Checked<geo::Ring> PolygonShapes::ring(const OGRLinearRing& line) const {
  geo::Ring ring;
  const bool global = straight_ && spans_the_globe(line);
  for (int i = 0; i < line.getNumPoints(); ++i) {
    const auto corner = place(line.getX(i), line.getY(i));
    if (!corner) return refuse(corner.error());
    if (!ring.empty() && ring.back() == *corner) continue;
    if (!ring.empty() && !straight_) {
      const auto divided = divide(line.getX(i - 1), line.getY(i - 1), ring.back(), line.getX(i), line.getY(i),
                                  *corner, most_divisions, ring);
      if (!divided) return refuse(divided.error());
    }
    // Such an edge leads around the Earth; without corners in between, it would count as having no length.
    if (!ring.empty() && straight_ &&
        (global || (is_pole(ring.back().lat_deg) && ring.back().lat_deg == corner->lat_deg)))
      add_way(ring, ring.back(), *corner);
    ring.push_back(*corner);
  }
  if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
  if (ring.size() < 3) return refuse(messages::ingest_area_message<"ring-too-short">());
  if (!straight_) return closed_over_pole(std::move(ring));
  return ring;
}

Checked<geo::Polygon> PolygonShapes::polygon(const OGRPolygon& shape) const {
  if (shape.getExteriorRing() == nullptr) return refuse(messages::ingest_area_message<"outline-empty">());
  auto outer = ring(*shape.getExteriorRing());
  if (!outer) return refuse(outer.error());
  geo::Polygon polygon{std::move(*outer), {}};
  for (int i = 0; i < shape.getNumInteriorRings(); ++i) {
    auto hole = ring(*shape.getInteriorRing(i));
    if (!hole) return refuse(hole.error());
    polygon.holes.push_back(std::move(*hole));
  }
  return polygon;
}

Checked<std::vector<geo::Polygon>> PolygonShapes::polygons(const OGRGeometry* geometry) const {
  if (geometry == nullptr) return refuse(messages::ingest_area_message<"outline-missing">());
  if (geometry->hasCurveGeometry() != 0) {
    const std::unique_ptr<OGRGeometry> lines{geometry->getLinearGeometry()};
    return polygons(lines.get());
  }
  const auto type = wkbFlatten(geometry->getGeometryType());
  std::vector<geo::Polygon> result;
  if (type == wkbPolygon) {
    auto one = polygon(*geometry->toPolygon());
    if (!one) return refuse(one.error());
    result.push_back(std::move(*one));
  } else if (type == wkbMultiPolygon || type == wkbGeometryCollection) {
    for (const OGRGeometry* part : geometry->toGeometryCollection()) {
      auto some = polygons(part);
      if (!some) return some;
      result.insert(result.end(), some->begin(), some->end());
    }
    if (result.empty()) return refuse(messages::ingest_area_message<"outline-empty">());
  } else {
    return refuse(messages::ingest_area_message<"outline-not-a-polygon">(OGRGeometryTypeToName(type)));
  }
  return result;
}

void remove_jumps(OGRGeometry& geometry) {
  class Unrolling : public OGRDefaultGeometryVisitor {
   public:
    using OGRDefaultGeometryVisitor::visit;
    void visit(OGRLinearRing* ring) override {
      if (spans_the_globe(*ring)) return;
      double shift_deg = 0.0;
      for (int i = 1; i < ring->getNumPoints(); ++i) {
        const double x_deg = ring->getX(i) + shift_deg;
        const double step_deg = x_deg - ring->getX(i - 1);
        const bool along_pole = is_pole(ring->getY(i)) && ring->getY(i) == ring->getY(i - 1);
        const double turn_deg =
            std::abs(step_deg) > 180.0 && !along_pole ? std::copysign(360.0, -step_deg) : 0.0;
        shift_deg += turn_deg;
        ring->setPoint(i, x_deg + turn_deg, ring->getY(i));
      }
    }
  };
  Unrolling unrolling;
  geometry.accept(&unrolling);
}

Checked<geo::Ring> closed_over_pole(geo::Ring ring) {
  const double turn_deg = geo::turn_of(ring);
  if (turn_deg == 0.0) return ring;
  const bool north = ring.front().lat_deg > 0.0;
  for (const geo::LonLat corner : ring)
    if (corner.lat_deg == 0.0 || (corner.lat_deg > 0.0) != north)
      return refuse(messages::ingest_area_message<"outline-round-the-earth">());

  const double pole_deg = north ? 90.0 : -90.0;
  const double end_deg = std::copysign(180.0, turn_deg);
  geo::Ring result;
  bool cut = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const geo::LonLat from = ring[i];
    const geo::LonLat to = ring[(i + 1) % ring.size()];
    result.push_back(from);
    const double lon_deg = geo::wrap_longitude(from.lon_deg);
    const double step_deg = geo::longitude_difference(from.lon_deg, to.lon_deg);
    const bool crosses = end_deg > 0.0 ? lon_deg + step_deg >= end_deg && step_deg > 0.0
                                       : lon_deg + step_deg < end_deg && step_deg < 0.0;
    if (cut || !crosses) continue;
    cut = true;
    const double lat_deg = from.lat_deg + (to.lat_deg - from.lat_deg) * (end_deg - lon_deg) / step_deg;
    result.push_back({end_deg, lat_deg});
    result.push_back({end_deg, pole_deg});
    add_way(result, {end_deg, pole_deg}, {-end_deg, pole_deg});
    result.push_back({-end_deg, pole_deg});
    result.push_back({-end_deg, lat_deg});
  }
  return result;
}

Checked<OGRSpatialReference> crs_of(OGRLayer& layer, const std::optional<std::string>& stated) {
  OGRSpatialReference crs;
  if (const OGRSpatialReference* const own = layer.GetSpatialRef()) {
    crs = *own;
  } else if (!stated) {
    return refuse(messages::ingest_area_message<"layer-without-crs">(layer.GetName()));
  } else if (!read_crs(*stated, crs)) {
    return refuse(messages::ingest_area_message<"crs-flag-unknown">(*stated));
  }
  crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return crs;
}

}  // namespace floeplan::ingest

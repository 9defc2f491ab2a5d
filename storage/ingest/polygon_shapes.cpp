#include "storage/ingest/polygon_shapes.hpp"

#include <ogr_geometry.h>
#include <ogr_spatialref.h>
#include <ogrsf_frmts.h>

#include <cmath>

#include "engine/geo/geodesic.hpp"
#include "storage/ingest/text.hpp"

namespace floeplan::ingest {
namespace {

constexpr double most_deviation_m = 10.0;  // far below the margins that anybody draws an area with
constexpr int most_divisions = 12;         // of an edge: 4096 parts

geo::LonLat middle(geo::LonLat a, geo::LonLat b) {
  return {geo::wrap_longitude(a.lon_deg + 0.5 * geo::longitude_difference(a.lon_deg, b.lon_deg)),
          0.5 * (a.lat_deg + b.lat_deg)};
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
    return refuse(std::string{"the coordinate reference system \""} +
                  (name != nullptr ? name : "without a name") +
                  "\" cannot be brought to WGS84; export the file again in EPSG:4326");
  }
  return shapes;
}

Checked<geo::LonLat> PolygonShapes::place(double x, double y) const {
  if (!std::isfinite(x) || !std::isfinite(y)) return refuse("a corner has no position");
  if (to_wgs84_ && to_wgs84_->Transform(1, &x, &y) == 0)
    return refuse("the corner " + number(x) + ", " + number(y) +
                  " lies outside its coordinate reference system");
  if (!std::isfinite(x) || !std::isfinite(y)) return refuse("a corner has no position");
  if (std::abs(y) > 90.0) return refuse("the latitude " + number(y) + " lies beyond a pole");
  if (x < -180.0 || x > 360.0) return refuse("the longitude " + number(x) + " is not within -180 and 360");
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
  for (int i = 0; i < line.getNumPoints(); ++i) {
    const auto corner = place(line.getX(i), line.getY(i));
    if (!corner) return refuse(corner.error());
    if (!ring.empty() && ring.back() == *corner) continue;
    if (!ring.empty() && !straight_) {
      const auto divided = divide(line.getX(i - 1), line.getY(i - 1), ring.back(), line.getX(i), line.getY(i),
                                  *corner, most_divisions, ring);
      if (!divided) return refuse(divided.error());
    }
    ring.push_back(*corner);
  }
  if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
  if (ring.size() < 3) return refuse("a ring has fewer than three corners");
  return ring;
}

Checked<geo::Polygon> PolygonShapes::polygon(const OGRPolygon& shape) const {
  if (shape.getExteriorRing() == nullptr) return refuse("it is empty");
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
  if (geometry == nullptr) return refuse("it has no geometry");
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
    if (result.empty()) return refuse("it is empty");
  } else {
    return refuse(std::string{"it is no polygon but a "} + OGRGeometryTypeToName(type));
  }
  return result;
}

Checked<OGRSpatialReference> crs_of(OGRLayer& layer, const std::optional<std::string>& stated) {
  OGRSpatialReference crs;
  if (const OGRSpatialReference* const own = layer.GetSpatialRef()) {
    crs = *own;
  } else if (!stated) {
    return refuse(
        std::string{"the layer \""} + layer.GetName() +
        "\" states no coordinate reference system (of a shapefile: the .prj file is missing); its areas "
        "could lie anywhere; give --crs, for example EPSG:4326");
  } else if (crs.SetFromUserInput(stated->c_str()) != OGRERR_NONE) {
    return refuse("--crs " + *stated + " is no coordinate reference system that is known; as EPSG:4326");
  }
  crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return crs;
}

}  // namespace floeplan::ingest

#include "storage/ingest/coastline_geojson_reader.hpp"

#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <cmath>

#include "engine/geo/polygon.hpp"
#include "storage/ingest/text.hpp"
#include "storage/repository/coastline_repository.hpp"

namespace floeplan::ingest {
namespace {

Checked<geo::Ring> ring_of(const OGRLinearRing& line) {
  geo::Ring ring;
  for (int i = 0; i < line.getNumPoints(); ++i) {
    const geo::LonLat place{line.getX(i), line.getY(i)};
    if (!std::isfinite(place.lon_deg) || !std::isfinite(place.lat_deg))
      return refuse("a corner has no position");
    if (std::abs(place.lat_deg) > 90.0)
      return refuse("the latitude " + number(place.lat_deg) + " lies beyond a pole");
    if (place.lon_deg < -180.0 || place.lon_deg > 360.0)
      return refuse("the longitude " + number(place.lon_deg) + " is not within -180 and 360");
    if (ring.empty() || ring.back() != place) ring.push_back(place);
  }
  if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
  if (ring.size() < 3) return refuse("a ring has fewer than three corners");
  return ring;
}

Checked<geo::Polygon> polygon_of(const OGRPolygon& shape) {
  if (shape.getExteriorRing() == nullptr) return refuse("it is empty");
  auto outer = ring_of(*shape.getExteriorRing());
  if (!outer) return refuse(outer.error());
  geo::Polygon polygon{std::move(*outer), {}};
  for (int i = 0; i < shape.getNumInteriorRings(); ++i) {
    auto hole = ring_of(*shape.getInteriorRing(i));
    if (!hole) return refuse(hole.error());
    polygon.holes.push_back(std::move(*hole));
  }
  return polygon;
}

Checked<std::vector<geo::Polygon>> polygons_of(const OGRGeometry* geometry) {
  std::vector<geo::Polygon> polygons;
  const auto type = geometry == nullptr ? wkbUnknown : wkbFlatten(geometry->getGeometryType());
  if (type == wkbPolygon) {
    auto polygon = polygon_of(*geometry->toPolygon());
    if (!polygon) return refuse(polygon.error());
    polygons.push_back(std::move(*polygon));
  } else if (type == wkbMultiPolygon) {
    for (const OGRPolygon* part : geometry->toMultiPolygon()) {
      auto polygon = polygon_of(*part);
      if (!polygon) return refuse(polygon.error());
      polygons.push_back(std::move(*polygon));
    }
  } else {
    return refuse("it is no polygon");
  }
  return polygons;
}

}  // namespace

Checked<PreparedDataset> read_geojson_coastline(GDALDataset& dataset) {
  OGRLayer& layer = *dataset.GetLayer(0);
  std::vector<geo::Polygon> land;
  int number_of_feature = 0;
  layer.ResetReading();
  for (const auto& feature : layer) {
    ++number_of_feature;
    auto polygons = polygons_of(feature->GetGeometryRef());
    if (!polygons)
      return refuse("feature " + std::to_string(number_of_feature) +
                    " cannot be used as land: " + polygons.error() +
                    "; land must not go missing, so nothing was stored; correct the file and try again");
    land.insert(land.end(), polygons->begin(), polygons->end());
  }

  std::vector<geo::LonLat> corners;
  for (const geo::Polygon& polygon : land)
    corners.insert(corners.end(), polygon.outer.begin(), polygon.outer.end());
  PreparedDataset data;
  data.kind = repository::DatasetKind::coastline;
  data.variables = {"land"};
  data.bounds = geo::bounding_box(corners);
  data.rows_accepted = static_cast<std::int64_t>(land.size());
  data.write = [land = std::move(land)](sqlite::Connection& db,
                                        const repository::DatasetId& id) -> tl::expected<void, std::string> {
    repository::CoastlineRepository{db}.insert(id, land);
    return {};
  };
  return data;
}

}  // namespace floeplan::ingest

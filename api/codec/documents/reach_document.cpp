#include "api/codec/documents/reach_document.hpp"

#include <cmath>

#include "api/codec/bytes/document_values.hpp"
#include "api/codec/documents/dataset_document.hpp"
#include "engine/core/utc_text.hpp"
#include "storage/json/json.hpp"

namespace floeplan::codec {
namespace {

using nlohmann::json;
using Direction = planning::IsochroneRequest::Direction;

double metre_degrees(double degrees) { return std::round(degrees * 1e6) / 1e6; }

json rounded_ring(const geo::Ring& ring) {
  json result = json::array();
  for (const geo::LonLat place : ring) {
    json at = json::array({metre_degrees(place.lon_deg), metre_degrees(place.lat_deg)});
    if (result.empty() || result.back() != at) result.push_back(std::move(at));
  }
  if (result.front() != result.back() || result.size() == 1) result.push_back(result.front());
  return result;
}

/// GeoJSON requires at least four positions in a ring. Rings that rounding leaves with fewer are dropped.
constexpr std::size_t least_positions = 4;

json multi_polygon(const std::vector<geo::Polygon>& polygons) {
  json coordinates = json::array();
  for (const geo::Polygon& polygon : polygons) {
    json rings = json::array({rounded_ring(polygon.outer)});
    if (rings.front().size() < least_positions) continue;
    for (const geo::Ring& hole : polygon.holes) {
      json ring = rounded_ring(hole);
      if (ring.size() >= least_positions) rings.push_back(std::move(ring));
    }
    coordinates.push_back(std::move(rings));
  }
  return {{"type", "MultiPolygon"}, {"coordinates", std::move(coordinates)}};
}

}  // namespace

json reach_document(const planning::Isochrones& reach, const planning::IsochroneRequest& request,
                    const std::string& name) {
  const bool from = request.direction == Direction::from;
  json features = json::array();
  for (const planning::Isochrone& area : reach.areas) {
    features.push_back({{"type", "Feature"},
                        {"properties",
                         {{"hours", area.span.count() / 3600.0},
                          {"time", core::iso8601(area.time)},
                          {"area_km2", area.area_m2 / 1e6}}},
                        {"geometry", multi_polygon(area.polygons)}});
  }
  json document{{"type", "FeatureCollection"},
                {"status", "ok"},
                {"name", name},
                {"direction", from ? "from" : "to"},
                {"place", {{"lon", request.place.lon_deg}, {"lat", request.place.lat_deg}}},
                {from ? "depart" : "arrive_by", core::iso8601(request.time)},
                {"vehicle", request.vehicle.name},
                {"spacing_m", request.step().value},
                {"features", std::move(features)},
                {"search",
                 {{"vertices", reach.search.vertices},
                  {"edges", reach.search.edges},
                  {"edge_evaluations", reach.search.edge_evaluations},
                  {"expansions", reach.search.expansions},
                  {"seconds", reach.search.duration.count()}}},
                {"datasets", dataset_refs_json(reach.datasets)}};
  tell(document, reach.messages);
  return document;
}

}  // namespace floeplan::codec

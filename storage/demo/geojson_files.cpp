#include "storage/demo/geojson_files.hpp"

#include <ogr_geometry.h>

#include <cmath>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string>

#include "engine/core/utc_text.hpp"
#include "storage/json/json.hpp"

namespace floeplan::demo {
namespace {

using Json = nlohmann::ordered_json;

double five_decimals(double degrees) { return std::round(degrees * 1e5) / 1e5; }

/// Writes each feature on a line of its own, so that people and line tools can read the file.
void write_collection(const std::filesystem::path& file, const Json& members,
                      const std::vector<Json>& features) {
  std::ofstream out{file, std::ios::binary | std::ios::trunc};
  out << "{\"type\":\"FeatureCollection\",\n";
  for (const auto& [key, value] : members.items()) out << Json(key).dump() << ':' << value.dump() << ",\n";
  out << "\"features\":[\n";
  for (std::size_t i = 0; i < features.size(); ++i)
    out << features[i].dump() << (i + 1 < features.size() ? ",\n" : "\n");
  out << "]}\n";
  out.close();
  if (!out) throw std::runtime_error{"cannot write " + file.string()};
}

std::unique_ptr<OGRLinearRing> ring_of(const geo::Ring& places) {
  auto ring = std::make_unique<OGRLinearRing>();
  for (const geo::LonLat place : places) ring->addPoint(place.lon_deg, place.lat_deg);
  ring->closeRings();
  return ring;
}

/// Rounding can make a ring touch itself. Such a polygon is added as the several valid polygons that it
/// consists of.
void add_valid(OGRMultiPolygon& pieces, const geo::Polygon& piece) {
  OGRPolygon polygon;
  polygon.addRingDirectly(ring_of(piece.outer).release());
  for (const geo::Ring& hole : piece.holes) polygon.addRingDirectly(ring_of(hole).release());
  const std::unique_ptr<OGRGeometry> valid{polygon.MakeValid()};
  if (const auto* const whole = dynamic_cast<const OGRPolygon*>(valid.get())) {
    pieces.addGeometry(whole);
  } else if (const auto* const parts = dynamic_cast<const OGRGeometryCollection*>(valid.get())) {
    for (const OGRGeometry* const part : *parts) {
      if (dynamic_cast<const OGRPolygon*>(part) != nullptr) pieces.addGeometry(part);
    }
  }
}

std::unique_ptr<OGRGeometry> joined(const std::vector<geo::Polygon>& land, const geo::BoundingBox& area) {
  OGRMultiPolygon pieces;
  for (const geo::Polygon& piece : land) add_valid(pieces, piece);
  OGRPolygon frame;
  frame.addRingDirectly(ring_of({{area.west_deg, area.south_deg},
                                 {area.east_deg, area.south_deg},
                                 {area.east_deg, area.north_deg},
                                 {area.west_deg, area.north_deg}})
                            .release());
  const std::unique_ptr<OGRGeometry> whole{pieces.UnionCascaded()};
  std::unique_ptr<OGRGeometry> cut{whole ? whole->Intersection(&frame) : nullptr};
  if (!cut) throw std::runtime_error{"joining the coastline failed; GDAL needs to be built with GEOS"};
  return cut;
}

Json ring_json(const OGRLinearRing& ring) {
  Json places = Json::array();
  for (int i = 0; i < ring.getNumPoints(); ++i)
    places.push_back({five_decimals(ring.getX(i)), five_decimals(ring.getY(i))});
  return places;
}

void add_features(const OGRGeometry& geometry, std::vector<Json>& features) {
  if (const auto* const polygon = dynamic_cast<const OGRPolygon*>(&geometry)) {
    Json rings = Json::array();
    for (const OGRLinearRing* const ring : *polygon) rings.push_back(ring_json(*ring));
    features.push_back({{"type", "Feature"},
                        {"properties", {{"level", 1}}},
                        {"geometry", {{"type", "Polygon"}, {"coordinates", rings}}}});
  } else if (const auto* const parts = dynamic_cast<const OGRGeometryCollection*>(&geometry)) {
    for (const OGRGeometry* const part : *parts) add_features(*part, features);
  }
}

Json members_of(const Origin& origin) {
  Json members{{"name", origin.name}, {"description", origin.description}};
  if (!origin.source.empty()) members["source"] = origin.source;
  members["license"] = origin.license;
  return members;
}

}  // namespace

void write_icebergs(const std::filesystem::path& file, const std::vector<ocean::Iceberg>& icebergs,
                    const Origin& origin) {
  std::vector<Json> features;
  for (const ocean::Iceberg& berg : icebergs) {
    Json properties{{"id", berg.id},
                    {"observed", core::iso8601(berg.observed)},
                    {"size", ocean::size_name(berg.size)},
                    {"method", berg.method}};
    if (berg.length) properties["length_m"] = berg.length->value;
    if (berg.draft) properties["draft_m"] = berg.draft->value;
    if (berg.position_uncertainty) properties["position_uncertainty_m"] = berg.position_uncertainty->value;
    features.push_back(
        {{"type", "Feature"},
         {"id", berg.id},
         {"properties", properties},
         {"geometry",
          {{"type", "Point"},
           {"coordinates", {five_decimals(berg.place.lon_deg), five_decimals(berg.place.lat_deg)}}}}});
  }
  write_collection(file, members_of(origin), features);
}

void write_coastline(const std::filesystem::path& file, const std::vector<geo::Polygon>& land,
                     const geo::BoundingBox& area, const Origin& origin) {
  std::vector<Json> features;
  add_features(*joined(land, area), features);
  write_collection(file, members_of(origin), features);
}

}  // namespace floeplan::demo

#include <algorithm>
#include <iterator>

#include "api/codec/features/polygon_rings.hpp"
#include "api/routes/request/parameters.hpp"
#include "api/routes/request/reply.hpp"
#include "api/routes/request/resources.hpp"
#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/repository/features/coastline_repository.hpp"

namespace floeplan::routes {
namespace {

using nlohmann::json;

/// Limit of an answer; beyond it the largest islands are kept. The map requests smaller areas.
constexpr std::size_t max_vertices = 400'000;

json polygon_json(json rings) {
  return {{"type", "Feature"},
          {"properties", json::object()},
          {"geometry", {{"type", "Polygon"}, {"coordinates", std::move(rings)}}}};
}

std::vector<geo::Polygon> load(sql::Connection& db, const geo::BoundingBox& area) {
  std::vector<geo::Polygon> land;
  for (const auto& dataset : repository::DatasetRepository{db}.list()) {
    if (dataset.kind != repository::DatasetKind::coastline) continue;
    auto polygons = repository::CoastlineRepository{db}.load(dataset.id, area);
    std::move(polygons.begin(), polygons.end(), std::back_inserter(land));
  }
  std::erase_if(land, [](const geo::Polygon& polygon) { return polygon.outer.empty(); });
  std::stable_sort(land.begin(), land.end(),
                   [](const auto& a, const auto& b) { return a.outer.size() > b.outer.size(); });
  return land;
}

Response show_coast(const Context& context, const Request& request, const PathParameters&) {
  ParameterReader reader{request};
  reader.require("bbox", "west,south,east,north in degrees");
  const auto area = reader.bbox();
  if (!reader.violations().empty()) return invalid(request, reader.violations());

  json features = json::array();
  std::size_t vertices = 0;
  bool complete = true;
  for (const auto& polygon : load(context.db, *area)) {
    vertices += polygon.outer.size();
    complete = features.empty() || vertices <= max_vertices;
    if (!complete) break;
    json rings = codec::polygon_rings(polygon, {});
    if (!rings.empty()) features.push_back(polygon_json(std::move(rings)));
  }
  Response response = geojson_reply(
      {{"type", "FeatureCollection"}, {"complete", complete}, {"features", std::move(features)}});
  response.headers.emplace_back("Cache-Control", "no-cache");
  return response;
}

}  // namespace

std::vector<Route> coast_routes() { return {{"GET", "/map/coast", {"bbox"}, show_coast}}; }

}  // namespace floeplan::routes

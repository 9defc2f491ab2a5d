#include <algorithm>
#include <cmath>

#include "api/codec/bytes/document_values.hpp"
#include "api/codec/documents/ice_egg.hpp"
#include "api/codec/features/polygon_rings.hpp"
#include "api/routes/request/parameters.hpp"
#include "api/routes/request/reply.hpp"
#include "api/routes/request/resources.hpp"
#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/repository/features/ice_chart_repository.hpp"

namespace floeplan::routes {
namespace {

using nlohmann::json;
using repository::DatasetKind;

/// Limits the answer to about two megabytes of text, more than a picture shows. The answer says if polygons
/// are omitted.
constexpr std::size_t most_corners = 100'000;

/// A grid with one node for each column of the picture, and the same distance northward as eastward.
codec::CornerGrid corners_of(const geo::BoundingBox& area, std::int64_t columns) {
  constexpr double least_width = 0.05;  // in degrees of longitude, near a pole
  const double middle_rad = core::degrees_to_radians(0.5 * (area.south_deg + area.north_deg));
  const double lon_deg = std::max(1e-5, geo::width_deg(area) / static_cast<double>(columns));
  return {lon_deg, lon_deg * std::max(least_width, std::cos(middle_rad))};
}

Response show_ice_chart(const Context& context, const Request& request, const PathParameters&) {
  ParameterReader reader{request};
  reader.require("bbox", "west,south,east,north in degrees");
  reader.require("nx", "the number of columns of the picture");
  reader.require("dataset", "the id of a dataset of kind ice");
  const auto area = reader.bbox();
  const auto nx = reader.integer("nx", 2, 8192);
  if (!reader.violations().empty()) return invalid(request, reader.violations());
  const std::string id = request.parameter("dataset").value_or("");
  const auto dataset = repository::DatasetRepository{context.db}.find({id});
  if (!dataset) return problem_reply<"unknown-dataset">(request, id);
  if (dataset->kind != DatasetKind::ice) {
    return invalid(request, {{"?dataset", "must be of kind ice, but " + id + " is of kind " +
                                              repository::kind_name(dataset->kind)}});
  }

  const codec::CornerGrid grid = corners_of(*area, *nx);
  json features = json::array();
  std::size_t corners = 0;
  bool complete = true;
  for (const auto& [codes, polygon] : repository::IceChartRepository{context.db}.load(dataset->id, *area)) {
    json rings = codec::polygon_rings(polygon, grid);
    for (const json& ring : rings) corners += ring.size();
    complete = features.empty() || corners <= most_corners;
    if (!complete) break;
    if (rings.empty()) continue;
    features.push_back({{"type", "Feature"},
                        {"properties", codec::ice_egg(codes)},
                        {"geometry", {{"type", "Polygon"}, {"coordinates", std::move(rings)}}}});
  }
  Response response = geojson_reply({{"type", "FeatureCollection"},
                                     {"complete", complete},
                                     {"dataset_id", dataset->id.value},
                                     {"dataset_name", dataset->name},
                                     {"time", codec::optional_time(dataset->time_start)},
                                     {"features", std::move(features)}});
  response.headers.emplace_back("Cache-Control", "no-cache");
  return response;
}

}  // namespace

std::vector<Route> ice_chart_routes() {
  return {{"GET", "/map/ice-chart", {"bbox", "nx", "dataset"}, show_ice_chart}};
}

}  // namespace floeplan::routes

#include "api/codec/plan_feature.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "api/codec/plan_document.hpp"
#include "engine/core/utc_text.hpp"

namespace floeplan::codec {
namespace {

using nlohmann::json;

json line_geometry(const std::vector<geo::LonLat>& route) {
  json lines = json::array({json::array()});
  for (std::size_t i = 0; i < route.size(); ++i) {
    if (i > 0 && std::abs(route[i].lon_deg - route[i - 1].lon_deg) > 180.0) {
      const double step = geo::longitude_difference(route[i - 1].lon_deg, route[i].lon_deg);
      const double edge = step > 0.0 ? 180.0 : -180.0;
      const double share = step == 0.0 ? 0.0 : (edge - route[i - 1].lon_deg) / step;
      const double lat = route[i - 1].lat_deg + share * (route[i].lat_deg - route[i - 1].lat_deg);
      lines.back().push_back({edge, lat});
      lines.push_back(json::array({json::array({-edge, lat})}));
    }
    lines.back().push_back({route[i].lon_deg, route[i].lat_deg});
  }
  if (lines.size() == 1) return {{"type", "LineString"}, {"coordinates", lines.front()}};
  return {{"type", "MultiLineString"}, {"coordinates", lines}};
}

}  // namespace

json plan_feature(const repository::PlanRecord& plan) {
  json document = json::parse(plan.document_json);
  json geometry = line_geometry(route_of(document));
  document["name"] = plan.name;
  document["created"] = core::iso8601(plan.created);
  return {{"type", "Feature"},
          {"id", plan.id.value},
          {"geometry", std::move(geometry)},
          {"properties", std::move(document)}};
}

}  // namespace floeplan::codec

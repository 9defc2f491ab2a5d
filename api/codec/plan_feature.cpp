#include "api/codec/plan_feature.hpp"

#include <nlohmann/json.hpp>

#include "api/codec/line_geometry.hpp"
#include "api/codec/plan_document.hpp"
#include "engine/core/utc_text.hpp"

namespace floeplan::codec {

using nlohmann::json;

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

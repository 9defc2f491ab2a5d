#include "api/routes/request/openapi_schema.hpp"

#include "api/openapi/openapi.hpp"

namespace floeplan::routes {

using nlohmann::json;

const json& component_schemas() {
  static const json schemas = json::parse(openapi::document()).at("components").at("schemas");
  return schemas;
}

json self_contained(const json& schema) {
  if (schema.is_object() && schema.contains("$ref")) {
    const std::string reference = schema.at("$ref").get<std::string>();
    return openapi_schema(reference.substr(reference.rfind('/') + 1));
  }
  if (!schema.is_structured()) return schema;
  json result = schema;
  for (json& member : result) member = self_contained(member);
  return result;
}

json openapi_schema(const std::string& component) {
  return self_contained(component_schemas().at(component));
}

}  // namespace floeplan::routes

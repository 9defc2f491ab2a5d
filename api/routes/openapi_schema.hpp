#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace floeplan::routes {

/// The component schemas of the OpenAPI document, by their names.
[[nodiscard]] const nlohmann::json& component_schemas();

/// The schema with every reference into the OpenAPI document put in its place, so that it stands alone.
[[nodiscard]] nlohmann::json self_contained(const nlohmann::json& schema);

/// A component of that name that stands alone.
[[nodiscard]] nlohmann::json openapi_schema(const std::string& component);

}  // namespace floeplan::routes

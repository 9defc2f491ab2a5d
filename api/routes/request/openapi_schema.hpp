#pragma once

#include <string>

#include "storage/json/json.hpp"

namespace floeplan::routes {

/// The media type of an OpenAPI document.
inline constexpr const char* openapi_type = "application/vnd.oai.openapi+json;version=3.0";

/// The component schemas of the OpenAPI document, by their names.
[[nodiscard]] const nlohmann::json& component_schemas();

/// The schema with every reference into the OpenAPI document put in its place, so that it stands alone.
[[nodiscard]] nlohmann::json self_contained(const nlohmann::json& schema);

/// A component of that name that stands alone.
[[nodiscard]] nlohmann::json openapi_schema(const std::string& component);

}  // namespace floeplan::routes

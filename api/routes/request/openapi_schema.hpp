#pragma once

#include <string>

#include "storage/json/json.hpp"

namespace floeplan::routes {

/// The media type of an OpenAPI document.
inline constexpr const char* openapi_type = "application/vnd.oai.openapi+json;version=3.0";

/// The component schemas of the OpenAPI document, by their names.
[[nodiscard]] const nlohmann::json& component_schemas();

/// The schema with all references to the OpenAPI document replaced by their content, so that it is complete
/// on its own.
[[nodiscard]] nlohmann::json self_contained(const nlohmann::json& schema);

/// The component with this name, with all references replaced.
[[nodiscard]] nlohmann::json openapi_schema(const std::string& component);

}  // namespace floeplan::routes

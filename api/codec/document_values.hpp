#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "engine/core/units.hpp"

/// Values as every document of ours writes them.
namespace floeplan::codec {

/// A longitude or latitude to 1e-7 degrees, which is a centimetre.
[[nodiscard]] double document_degrees(double degrees);
/// ISO 8601, or null.
[[nodiscard]] nlohmann::json optional_time(const std::optional<core::UtcTime>& time);
/// A time that a stored document of ours must have.
/// Errors   throws std::runtime_error naming `key`
[[nodiscard]] core::UtcTime stored_time(const nlohmann::json& object, const char* key);

}  // namespace floeplan::codec

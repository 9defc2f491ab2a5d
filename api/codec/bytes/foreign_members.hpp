#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

/// Reads members of JSON objects from outside, which may be missing or of another type.
namespace floeplan::codec {

/// The text under this key; empty if there is none.
[[nodiscard]] std::string text_at(const nlohmann::json& object, const char* key);
/// The number under this key; empty if there is none.
[[nodiscard]] std::optional<double> number_at(const nlohmann::json& object, const char* key);

}  // namespace floeplan::codec

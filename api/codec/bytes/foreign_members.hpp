#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

/// Members of objects that others wrote, where everything may be missing or of another type.
namespace floeplan::codec {

/// Empty where there is no text of that name.
[[nodiscard]] std::string text_at(const nlohmann::json& object, const char* key);
/// Empty where there is no number of that name.
[[nodiscard]] std::optional<double> number_at(const nlohmann::json& object, const char* key);

}  // namespace floeplan::codec

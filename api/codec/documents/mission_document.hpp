#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "engine/mission/document/document.hpp"

namespace floeplan::codec {

/// A mission file as it was read, with the verdict on it and the first 200 messages of each severity. `file` is how the
/// user named it.
[[nodiscard]] nlohmann::json mission_document(const mission::Document& document, const std::string& file);

}  // namespace floeplan::codec

#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "engine/mission/document/document.hpp"

namespace floeplan::codec {

/// The result of reading a mission file: its content, the verdict, and the first 200 messages of each
/// severity. `file` is the user's name for the file.
[[nodiscard]] nlohmann::json mission_document(const mission::Document& document, const std::string& file);

}  // namespace floeplan::codec

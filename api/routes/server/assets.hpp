#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "api/routes/request/message.hpp"

namespace floeplan::routes {

/// A file below `folder` with its media type; nullopt if it does not exist or the name leads out of the
/// folder.
[[nodiscard]] std::optional<Response> read_asset(const std::filesystem::path& folder,
                                                 const std::string& name);

}  // namespace floeplan::routes

#pragma once

#include <nlohmann/json_fwd.hpp>

namespace floeplan::codec {

/// A stored plan document with every member that this version reads. A member that the version of the plan did not know
/// yet gets the value for "unknown" or "none"; the members that are there stay. The stored bytes do not change.
/// Errors   nlohmann::json::exception where a member is missing that every version wrote
[[nodiscard]] nlohmann::json with_later_members(nlohmann::json document);

}  // namespace floeplan::codec

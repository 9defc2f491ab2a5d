#pragma once

#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "storage/json/json.hpp"

namespace floeplan::codec {

/// Deeper nesting than any message of ours needs, shallow enough for code that walks it recursively.
inline constexpr int max_json_depth = 64;

/// Parses text from outside. The depth is checked in a first pass that builds nothing, so nested input costs
/// no stack.
/// Errors   what is wrong and where, for a person; also for NaN, infinity and numbers beyond a double, and for an
///          object that has a key twice: which of the values counts differs from reader to reader
[[nodiscard]] tl::expected<nlohmann::json, std::string> parse_json(std::string_view text);

}  // namespace floeplan::codec

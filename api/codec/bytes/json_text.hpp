#pragma once

#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "storage/json/json.hpp"

namespace floeplan::codec {

/// Largest nesting depth: more than any message of Floeplan needs, and small enough for recursive code.
inline constexpr int max_json_depth = 64;

/// Parses JSON text from outside. A first pass checks the nesting depth without building anything, so that
/// deeply nested input needs no stack.
/// Errors   the fault and its place, for the user; also NaN, infinity, numbers beyond a double, and an object
///          with a key twice, because readers differ in which of the values they use
[[nodiscard]] tl::expected<nlohmann::json, std::string> parse_json(std::string_view text);

}  // namespace floeplan::codec

#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace floeplan::codec {

/// The whole text as a finite number, a sign before it allowed; empty: it is none.
[[nodiscard]] std::optional<double> parse_number(std::string_view text);

/// The whole text as a whole number; empty: it is none, or beyond 64 bits.
[[nodiscard]] std::optional<std::int64_t> parse_integer(std::string_view text);

/// What stands between the separators, one part more than there are of them.
[[nodiscard]] std::vector<std::string_view> split(std::string_view text, char separator);

/// Without the spaces and tabs at either end that a header may have (RFC 9110, 5.6.3).
[[nodiscard]] std::string_view trimmed(std::string_view text);

}  // namespace floeplan::codec

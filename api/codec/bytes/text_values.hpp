#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace floeplan::codec {

/// The number, if the whole text is a finite number, also with a sign; otherwise empty.
[[nodiscard]] std::optional<double> parse_number(std::string_view text);

/// The number, if the whole text is a whole number of at most 64 bits; otherwise empty.
[[nodiscard]] std::optional<std::int64_t> parse_integer(std::string_view text);

/// The parts between the separators; one more than there are separators.
[[nodiscard]] std::vector<std::string_view> split(std::string_view text, char separator);

/// The text without spaces and tabs at either end, which a header may have (RFC 9110, 5.6.3).
[[nodiscard]] std::string_view trimmed(std::string_view text);

}  // namespace floeplan::codec

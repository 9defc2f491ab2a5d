#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace floeplan::ingest {

/// ASCII lower case; other bytes are left alone.
[[nodiscard]] std::string lower(std::string_view text);
/// The text without blanks, tabs and line ends at both sides.
[[nodiscard]] std::string trimmed(std::string_view text);
/// Whether any of the words occurs in the text.
[[nodiscard]] bool contains_any(std::string_view text, std::initializer_list<std::string_view> words);
/// "a, b and c"; at most `limit` names, then "...".
[[nodiscard]] std::string enumeration(const std::vector<std::string>& names, std::size_t limit = 8);
/// The words of a text, split at blanks, tabs and line ends.
[[nodiscard]] std::vector<std::string> words_between_blanks(const std::string& text);
/// A number as people write it: at most `digits` significant digits, no trailing zeros.
[[nodiscard]] std::string number(double value, int digits = 6);
/// Whether the character is an ASCII digit, whatever the locale.
[[nodiscard]] constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }
/// The number, if the whole text is a finite number; independent of the locale.
[[nodiscard]] std::optional<double> parse_number(std::string_view text);

}  // namespace floeplan::ingest

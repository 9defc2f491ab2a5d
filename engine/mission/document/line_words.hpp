#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace floeplan::mission {

/// A line without its comment, and the comment from its '#'.
struct SplitLine {
  std::string_view content;  // without blanks at its ends
  std::string_view comment;  // without blanks at its end
};
[[nodiscard]] SplitLine split_comment(std::string_view line);

/// The parts of a text between blanks and tabs.
[[nodiscard]] std::vector<std::string_view> words_of(std::string_view content);

/// Parses a decimal number as in the vehicle's files: "7", "007", "-1", "10.", "-.43", "+2", "1e3".
/// Outside  empty for all else: words, NaN, infinity, hexadecimal, numbers beyond a double
[[nodiscard]] std::optional<double> parse_number(std::string_view word);

/// Whether the word consists of 1 to 64 letters, digits and underscores.
[[nodiscard]] bool is_name(std::string_view word);

[[nodiscard]] inline bool is_digit(char c) { return c >= '0' && c <= '9'; }

}  // namespace floeplan::mission

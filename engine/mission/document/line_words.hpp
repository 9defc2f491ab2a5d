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

/// The parts between blanks and tabs.
[[nodiscard]] std::vector<std::string_view> words_of(std::string_view content);

/// A decimal number as the vehicle's files have them: "7", "007", "-1", "10.", "-.43", "+2", "1e3".
/// Outside  nothing for anything else: words, NaN, infinity, hexadecimal, numbers beyond a double
[[nodiscard]] std::optional<double> parse_number(std::string_view word);

/// Letters, digits and underscores, at least one and at most 64.
[[nodiscard]] bool is_name(std::string_view word);

[[nodiscard]] inline bool is_digit(char c) { return c >= '0' && c <= '9'; }

}  // namespace floeplan::mission

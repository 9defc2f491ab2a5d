#pragma once

#include <cstddef>
#include <string>

#include "engine/core/violation.hpp"

/// Lists of violations with a limited length: a request of a megabyte can break a rule a hundred thousand
/// times.
namespace floeplan::core {

/// Largest number of violations in a list. A person hardly corrects more at once.
inline constexpr std::size_t most_violations = 100;

/// Adds a violation, with its texts cut short. If the list already holds `most_violations`, adds one that
/// says that there are more. Further violations are dropped.
void note(Violations& list, Violation violation);

/// Whether `note` adds nothing any more, so that a check may end.
[[nodiscard]] bool is_full(const Violations& list);

/// The list shortened as by calls of `note` with each violation.
[[nodiscard]] Violations shortened(const Violations& violations);

/// The text, if it has at most `most_bytes` bytes. Otherwise whole UTF-8 characters from its beginning and
/// "...".
/// Precondition  `most_bytes` is at least 3
[[nodiscard]] std::string cut_short(std::string text, std::size_t most_bytes);

}  // namespace floeplan::core

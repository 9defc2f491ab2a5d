#pragma once

#include <cstddef>
#include <string>

#include "engine/core/violation.hpp"

/// Lists of violations that stay short however much is wrong: a request of a megabyte can break a rule a hundred
/// thousand times.
namespace floeplan::core {

/// More than a person corrects at once.
inline constexpr std::size_t most_violations = 100;

/// Adds a violation, its texts cut short. To a list of `most_violations` it adds one that says that there are more
/// instead, and after that nothing.
void note(Violations& list, Violation violation);

/// Whether nothing more is noted: who looks for more may end.
[[nodiscard]] bool is_full(const Violations& list);

/// The list as `note` makes it of the same violations.
[[nodiscard]] Violations shortened(const Violations& violations);

/// The text; of one with more bytes as many whole UTF-8 characters from its beginning as there is room for with "...".
/// Precondition  `most_bytes` is 3 at least
[[nodiscard]] std::string cut_short(std::string text, std::size_t most_bytes);

}  // namespace floeplan::core

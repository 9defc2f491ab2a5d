#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace floeplan::core {

/// The rank of a sentence for the pilot. Sentences travel as text from the data to plan, page and terminal, and the rank
/// with them: one that tells of a danger, which may cost the vehicle and is told again at every export, begins
/// with this mark; any other is a caution or a note.
inline constexpr std::string_view danger_mark = "Danger: ";

[[nodiscard]] std::string as_danger(std::string_view text);
[[nodiscard]] bool is_danger(std::string_view sentence);

/// Without the mark, for a place that shows the rank in another way.
[[nodiscard]] std::string without_mark(std::string_view sentence);

/// Those that tell of a danger, in their order, as they are.
[[nodiscard]] std::vector<std::string> dangers_among(const std::vector<std::string>& sentences);

/// Dangers first, each rank in its order.
[[nodiscard]] std::vector<std::string> by_rank(std::vector<std::string> sentences);

}  // namespace floeplan::core

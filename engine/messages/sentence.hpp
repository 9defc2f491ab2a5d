#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/messages/message.hpp"

/// Messages as plain sentences, for where only words are shown or stored: the rank travels in them.
namespace floeplan::messages {

/// How the sentence of a danger begins, which may cost the vehicle and is told again at every export; any other is a
/// caution or a note.
inline constexpr std::string_view danger_mark = "Danger: ";

[[nodiscard]] bool is_danger(std::string_view sentence);

/// Without the mark, for a place that shows the rank in another way.
[[nodiscard]] std::string without_mark(std::string_view sentence);

/// What is the matter and what to do. The hint follows as a sentence of its own where it begins with a capital, after
/// the text's colon where that ends in one, else after a semicolon.
[[nodiscard]] std::string whole_text(const Message& message);

/// The whole text as a rule that the field breaks.
[[nodiscard]] core::Violation violation_of(std::string field, Message message);

/// The whole text with its rank.
[[nodiscard]] std::string sentence(const Message& message);
[[nodiscard]] std::vector<std::string> sentences(const std::vector<Message>& messages);

/// The sentences of the dangers among them.
[[nodiscard]] std::vector<std::string> dangers_among(const std::vector<Message>& messages);

/// Dangers first, the rest in its order.
[[nodiscard]] std::vector<std::string> dangers_first(std::vector<std::string> sentences);

}  // namespace floeplan::messages

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/messages/message.hpp"

/// Messages as plain sentences, for places that show or store only text. The sentence includes the rank.
namespace floeplan::messages {

/// Prefix of the sentence of a danger, which may cost the vehicle and is repeated at every export. Sentences
/// without it are cautions or notes.
inline constexpr std::string_view danger_mark = "Danger: ";

[[nodiscard]] bool is_danger(std::string_view sentence);

/// The sentence without the mark, for places that show the rank in another way.
[[nodiscard]] std::string without_mark(std::string_view sentence);

/// Text and hint in one. A hint that begins with a capital follows as a sentence. Otherwise it follows the
/// text's final colon or, without one, a semicolon.
[[nodiscard]] std::string whole_text(const Message& message);

/// The whole text as the rule of a violation of the field.
[[nodiscard]] core::Violation violation_of(std::string field, Message message);

/// The whole text, with the mark if it is a danger.
[[nodiscard]] std::string sentence(const Message& message);
[[nodiscard]] std::vector<std::string> sentences(const std::vector<Message>& messages);

/// The sentences of those messages that are dangers.
[[nodiscard]] std::vector<std::string> dangers_among(const std::vector<Message>& messages);

/// The sentences with dangers first; otherwise the order stays.
[[nodiscard]] std::vector<std::string> dangers_first(std::vector<std::string> sentences);

}  // namespace floeplan::messages

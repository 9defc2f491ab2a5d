#include "engine/messages/sentence.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace floeplan::messages {

bool is_danger(std::string_view sentence) { return sentence.starts_with(danger_mark); }

std::string without_mark(std::string_view sentence) {
  return std::string{is_danger(sentence) ? sentence.substr(danger_mark.size()) : sentence};
}

std::string whole_text(const Message& message) {
  if (message.hint.empty()) return message.text;
  const bool is_sentence = message.hint.front() >= 'A' && message.hint.front() <= 'Z';
  const char* const between = message.text.ends_with(':') ? " " : (is_sentence ? ". " : "; ");
  return message.text + between + message.hint;
}

core::Violation violation_of(std::string field, Message message) {
  std::string rule = whole_text(message);
  return {std::move(field), std::move(rule), std::move(message.code), std::move(message.values)};
}

std::string sentence(const Message& message) {
  const std::string text = whole_text(message);
  return is_grave(message) ? std::string{danger_mark} + text : text;
}

std::vector<std::string> sentences(const std::vector<Message>& messages) {
  std::vector<std::string> told;
  std::ranges::transform(messages, std::back_inserter(told), sentence);
  return told;
}

std::vector<std::string> dangers_among(const std::vector<Message>& messages) {
  std::vector<std::string> told;
  for (const Message& message : messages)
    if (is_grave(message)) told.push_back(sentence(message));
  return told;
}

std::vector<std::string> dangers_first(std::vector<std::string> sentences) {
  std::ranges::stable_partition(sentences, is_danger);
  return sentences;
}

}  // namespace floeplan::messages

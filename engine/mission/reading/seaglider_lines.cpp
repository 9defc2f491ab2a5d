#include "engine/mission/reading/seaglider_lines.hpp"

#include <algorithm>

#include "engine/messages/seaglider_file_messages.hpp"
#include "engine/mission/document/line_words.hpp"

namespace floeplan::mission {
namespace {

bool is_printable_ascii(std::string_view text) {
  return std::ranges::all_of(text, [](char c) { return (c >= ' ' && c <= '~') || c == '\t'; });
}

std::string joined(const std::vector<std::string_view>& words) {
  std::string text;
  for (const std::string_view word : words) text += (text.empty() ? "" : " ") + std::string{word};
  return text;
}

}  // namespace

std::optional<std::pair<std::string_view, std::string_view>> SeagliderLine::field(std::string_view word) {
  const std::size_t equals = word.find('=');
  if (equals == 0 || equals == std::string_view::npos || equals + 1 == word.size() ||
      word.find('=', equals + 1) != std::string_view::npos)
    return std::nullopt;
  return std::pair{word.substr(0, equals), word.substr(equals + 1)};
}

std::vector<SeagliderLine> seaglider_lines(const FileText& text, Document& document) {
  std::vector<SeagliderLine> lines;
  for (std::size_t i = 0; i < text.lines.size(); ++i) {
    const std::string_view line = text.lines[i];
    const int number = static_cast<int>(i) + 1;
    const auto words = words_of(line);
    const bool comment = !words.empty() && words.front().starts_with('/');
    document.lines.push_back(comment ? SourceLine{"", joined(words)} : SourceLine{joined(words), ""});
    if (!is_printable_ascii(line))
      report(document, number,
             comment ? messages::seaglider_file_message<"not_ascii/comment">()
                     : messages::seaglider_file_message<"not_ascii">());
    if (!comment && !words.empty()) lines.push_back({number, words});
  }
  return lines;
}

}  // namespace floeplan::mission

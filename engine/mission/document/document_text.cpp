#include "engine/mission/document/document_text.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "engine/mission/document/behavior_table.hpp"

namespace floeplan::mission {
namespace {

/// The text with one '?' for each character outside ASCII and each control character.
std::string ascii(const std::string& utf8) {
  std::string text;
  for (const char c : utf8) {
    const bool continues = (static_cast<unsigned char>(c) & 0xC0) == 0x80;
    if (continues) continue;
    text += (c >= ' ' && c <= '~') || c == '\t' ? c : '?';
  }
  return text;
}

}  // namespace

std::string write_document(const Document& document) {
  if (document.verdict() == Verdict::reject)
    throw std::invalid_argument{"write_document: a rejected document cannot be written"};
  std::string text;
  for (const SourceLine& line : document.lines) {
    text += line.content;
    if (!line.content.empty() && !line.comment.empty()) text += ' ';
    text += ascii(line.comment) + '\n';
  }
  return text;
}

std::vector<std::string> files_referenced(const Document& document) {
  std::vector<std::string> names;
  if (document.kind != DocumentKind::mission) return names;
  for (const Behavior& behavior : document.behaviors) {
    const Argument* file = behavior.find("args_from_file");
    if (file == nullptr || file->value < 0.0 || file->value > 99.0 || file->value != std::floor(file->value))
      continue;
    std::array<char, 8> number{};
    std::snprintf(number.data(), number.size(), "%02d", static_cast<int>(file->value));
    names.push_back(std::string{file_prefix(behavior.name)} + number.data() + ".ma");
  }
  return names;
}

}  // namespace floeplan::mission

#include "engine/mission/document/line_words.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace floeplan::mission {
namespace {

constexpr std::string_view blanks = " \t\f\v";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

}  // namespace

SplitLine split_comment(std::string_view line) {
  const std::size_t hash = line.find('#');
  if (hash == std::string_view::npos) return {trimmed(line), {}};
  return {trimmed(line.substr(0, hash)), trimmed(line.substr(hash))};
}

std::vector<std::string_view> words_of(std::string_view content) {
  std::vector<std::string_view> words;
  std::size_t begin = content.find_first_not_of(blanks);
  while (begin != std::string_view::npos) {
    const std::size_t end = std::min(content.find_first_of(blanks, begin), content.size());
    words.push_back(content.substr(begin, end - begin));
    begin = content.find_first_not_of(blanks, end);
  }
  return words;
}

std::optional<double> parse_number(std::string_view word) {
  if (word.starts_with('+')) {
    word.remove_prefix(1);
    if (word.starts_with('-')) return std::nullopt;
  }
  // from_chars also accepts "inf" and "nan", so a number must begin with a digit or a point.
  const std::string_view unsigned_part = word.starts_with('-') ? word.substr(1) : word;
  if (unsigned_part.empty() || !(is_digit(unsigned_part.front()) || unsigned_part.front() == '.'))
    return std::nullopt;
  double value{};
  const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (fault != std::errc{} || end != word.data() + word.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

bool is_name(std::string_view word) {
  return !word.empty() && word.size() <= 64 &&
         std::ranges::all_of(word, [](char c) { return is_letter(c) || is_digit(c) || c == '_'; });
}

}  // namespace floeplan::mission

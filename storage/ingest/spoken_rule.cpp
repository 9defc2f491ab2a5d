#include "storage/ingest/spoken_rule.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <string>

#include "storage/ingest/text.hpp"

namespace floeplan::ingest {
namespace {

constexpr auto of_stay_in = std::to_array<std::string_view>(
    {"stay in", "stay inside", "stay within", "stayin", "keep in", "keep inside", "keep within", "keepin",
     "remain in", "remain inside", "remain within", "not leave", "inclusion"});
constexpr auto of_no_go = std::to_array<std::string_view>(
    {"no go", "nogo", "keep out", "keepout", "keep clear", "keep away", "stay out", "stayout", "stay outside",
     "stay away", "not enter", "no entry", "exclusion", "prohibited", "forbidden", "avoid"});

/// " stay in box until june ": words in lower case with one blank around each.
std::string in_plain_words(std::string_view text) {
  std::string words = " ";
  for (const char c : lower(text)) {
    const bool is_sign = (c >= 0 && c < '0') || (c > '9' && c < 'a') || (c > 'z' && c <= '~');
    if (!is_sign) words += c;
    if (is_sign && words.back() != ' ') words += ' ';
  }
  return words + ' ';
}

}  // namespace

bool has_words_of(std::string_view text, ocean::ZoneKind rule) {
  const std::string words = in_plain_words(text);
  const std::span<const std::string_view> phrases = rule == ocean::ZoneKind::stay_in
                                                        ? std::span<const std::string_view>{of_stay_in}
                                                        : std::span<const std::string_view>{of_no_go};
  return std::ranges::any_of(phrases, [&](std::string_view phrase) {
    return words.find(' ' + std::string{phrase} + ' ') != std::string::npos;
  });
}

}  // namespace floeplan::ingest

#include "storage/ingest/notation/stated_rule.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <span>
#include <string>

#include "engine/core/letter_case.hpp"
#include "storage/ingest/notation/stated_depth.hpp"
#include "storage/ingest/notation/stated_period.hpp"
#include "storage/ingest/notation/text.hpp"

namespace floeplan::ingest {
namespace {

using ocean::AttributeMeaning;

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

bool is_any_of(std::string_view text, std::initializer_list<std::string_view> words) {
  const std::string word = core::plain_word(text);
  return std::ranges::any_of(words, [&](std::string_view other) { return word == other; });
}

/// The rule that a text states without doubt, whatever the attribute's name.
std::optional<ocean::ZoneKind> plain_rule(std::string_view text) {
  std::string word = core::plain_word(text);
  for (const std::string_view ending : {"zone", "area"})
    if (word.ends_with(ending)) word.resize(word.size() - ending.size());
  if (is_any_of(word, {"nogo", "keepout", "stayout"})) return ocean::ZoneKind::no_go;
  if (is_any_of(word, {"stayin", "keepin"})) return ocean::ZoneKind::stay_in;
  return std::nullopt;
}

}  // namespace

std::optional<ocean::ZoneKind> zone_kind_of(std::string_view text) {
  if (is_any_of(text, {"exclusion", "exclusionzone", "exclusionarea"})) return ocean::ZoneKind::no_go;
  if (is_any_of(text, {"inclusion", "inclusionzone", "inclusionarea"})) return ocean::ZoneKind::stay_in;
  return plain_rule(text);
}

std::optional<ocean::ZoneKind> stated_rule(AttributeMeaning meaning, std::string_view text) {
  using enum AttributeMeaning;
  if (meaning == zone_name) return std::nullopt;
  return meaning == kind || meaning == perhaps_kind ? zone_kind_of(text) : plain_rule(text);
}

bool is_without_end(std::string_view text) {
  return is_any_of(text, {"permanent", "permanently", "yearround", "allyear", "always", "indefinite"});
}

bool is_yes(std::string_view text) { return is_any_of(text, {"yes", "y", "true", "t", "1"}); }

bool says_what_a_zone_is(std::string_view name, std::string_view text) {
  using enum AttributeMeaning;
  const AttributeMeaning meaning = ocean::meaning_of_attribute(name);
  switch (meaning) {
    case kind:
    case from:
    case until:
    case top:
    case bottom: return true;
    case period: return !is_yes(text) && !is_without_end(text);
    case unclear_period: return could_be_date(text);
    case depths: return stated_depths(text, ocean::unit_in_attribute(name)).has_value();
    default: return stated_rule(meaning, text).has_value();
  }
}

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

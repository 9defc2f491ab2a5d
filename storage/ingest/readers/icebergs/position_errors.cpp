#include "storage/ingest/readers/icebergs/position_errors.hpp"

#include <algorithm>
#include <span>

#include "engine/messages/ingest_iceberg_messages.hpp"
#include "storage/ingest/notation/cf_units.hpp"
#include "storage/ingest/notation/text.hpp"
#include "storage/ingest/readers/icebergs/iceberg_rows.hpp"

namespace floeplan::ingest {
namespace {

constexpr std::string_view error_words[]{"error", "errors", "err",       "uncertainty", "uncertain", "uncert",
                                         "unc",   "acc",    "precision", "accuracy",    "inaccuracy"};
/// Words for a statistical spread. They mean a position error only together with a word for a position.
constexpr std::string_view spread_words[]{"sigma", "std",  "stddev", "stdev", "sd",
                                          "rms",   "rmse", "cep",    "radius"};
constexpr std::string_view position_words[]{"position",    "positions",  "positional", "pos",   "posn",
                                            "location",    "loc",        "horizontal", "horiz", "geolocation",
                                            "coordinates", "coordinate", "place",      "fix",   "gps"};
/// Words that do not change the meaning of a column's name.
constexpr std::string_view other_words[]{"iceberg",   "berg",   "of",     "in",   "estimate",
                                         "estimated", "est",    "max",    "mean", "expected",
                                         "maximum",   "circle", "nominal"};

bool is_in(std::span<const std::string_view> words, std::string_view word) {
  return std::ranges::find(words, word) != words.end();
}

bool is_lower(char c) { return c >= 'a' && c <= 'z'; }
bool is_upper(char c) { return c >= 'A' && c <= 'Z'; }

/// Adds a word; a word such as "poserr" is split into "pos" and "err".
void add_word(std::vector<std::string>& words, const std::string& word) {
  for (std::size_t length = 1; length < word.size(); ++length) {
    const std::string first = word.substr(0, length);
    const std::string second = word.substr(length);
    if (!is_in(position_words, first) || !is_in(error_words, second)) continue;
    words.insert(words.end(), {first, second});
    return;
  }
  if (!word.empty()) words.push_back(word);
}

/// The words of a name in lower case: "posErrM", "Pos. err (m)" and "POS_ERR_M" give the same three words.
std::vector<std::string> words_of(const std::string& name) {
  std::vector<std::string> words;
  std::string word;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const char c = name[i];
    const bool begins =
        i > 0 && is_upper(c) &&
        (is_lower(name[i - 1]) || (is_upper(name[i - 1]) && i + 1 < name.size() && is_lower(name[i + 1])));
    const bool separates = !is_lower(c) && !is_upper(c) && !is_digit(c);
    if (begins || separates) {
      add_word(words, lower(word));
      word.clear();
    }
    if (!separates) word += c;
  }
  add_word(words, lower(word));
  return words;
}

/// Metres per unit, if the last words name a unit of length; removes these words.
std::optional<double> take_unit(std::vector<std::string>& words) {
  constexpr double nautical_mile_m = 1852.0;
  for (const std::size_t length : {std::size_t{2}, std::size_t{1}}) {
    if (words.size() <= length) continue;
    const auto first = words.end() - static_cast<std::ptrdiff_t>(length);
    std::string unit;
    for (auto word = first; word != words.end(); ++word) unit += *word;
    const auto metres = unit == "nm" ? std::optional{nautical_mile_m} : length_factor(unit);
    if (!metres) continue;
    words.erase(first, words.end());
    return metres;
  }
  return std::nullopt;
}

/// Whether the words, without the unit, can only mean a position error.
bool mean_position_error(const std::vector<std::string>& words) {
  const auto any = [&](std::span<const std::string_view> set) {
    return std::ranges::any_of(words, [&](const std::string& word) { return is_in(set, word); });
  };
  const bool named = any(error_words) || (any(position_words) && any(spread_words));
  return named && std::ranges::all_of(words, [](const std::string& word) {
           return is_in(error_words, word) || is_in(spread_words, word) || is_in(position_words, word) ||
                  is_in(other_words, word) || std::ranges::all_of(word, is_digit);
         });
}

}  // namespace

PositionErrors::PositionErrors(const std::vector<std::string>& names,
                               const std::vector<std::string_view>& read_otherwise) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    std::vector<std::string> words = words_of(names[i]);
    const bool speaks = std::ranges::any_of(
        words, [](const std::string& word) { return is_in(error_words, word) || is_in(spread_words, word); });
    if (!speaks || std::ranges::find(read_otherwise, lower(trimmed(names[i]))) != read_otherwise.end())
      continue;
    const auto metres = take_unit(words);
    if (metres && mean_position_error(words)) {
      columns_.push_back({i, names[i], *metres});
    } else {
      not_read_.push_back(names[i]);
    }
  }
}

Checked<std::optional<core::Metres>> PositionErrors::of(const Text& text, const Number& number) const {
  std::optional<core::Metres> largest;
  for (const Column& column : columns_) {
    const std::string value = text(column.index);
    auto length = number(value);
    if (length) *length *= column.metres;
    const auto error = metres_of(column.name, value, length, least_certain_m, Zero::allowed);
    if (!error) return refuse(error.error());
    if (*error && (!largest || **error > *largest)) largest = *error;
  }
  return largest;
}

bool PositionErrors::is_read(std::size_t column) const {
  return std::ranges::find(columns_, column, &Column::index) != columns_.end();
}

Messages PositionErrors::warnings() const {
  Messages warnings;
  for (const std::string& name : not_read_)
    warnings.push_back(messages::ingest_iceberg_message<"iceberg-error-not-read">(name));
  return warnings;
}

Checked<ocean::Iceberg> with_position_error(ocean::Iceberg iceberg, const PositionErrors& errors,
                                            const std::vector<std::string>& fields) {
  const auto error = errors.of([&](std::size_t column) { return trimmed(fields[column]); }, parse_number);
  if (!error) return refuse(error.error());
  if (*error) iceberg.position_uncertainty = *error;
  return iceberg;
}

}  // namespace floeplan::ingest

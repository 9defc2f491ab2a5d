#include "storage/ingest/notation/stated_period.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <chrono>
#include <string>
#include <utility>

#include "engine/core/utc_text.hpp"
#include "storage/ingest/notation/table_dates.hpp"
#include "storage/ingest/notation/text.hpp"

namespace floeplan::ingest {
namespace {

constexpr std::size_t digits_of_year = std::string_view{"2026"}.size();
constexpr std::size_t digits_of_month = std::string_view{"2026-05"}.size();
constexpr std::size_t day_length = std::string_view{"2026-05-01"}.size();
constexpr std::size_t compact_length = std::string_view{"20260501"}.size();

constexpr auto month_beginnings = std::to_array<std::string_view>(
    {"jan", "feb", "mar", "apr", "may", "jun", "jul", "aug", "sep", "oct", "nov", "dec"});

constexpr auto months =
    std::to_array<std::string_view>({"january", "february", "march", "april", "may", "june", "july", "august",
                                     "september", "october", "november", "december"});

core::UtcTime midnight(std::chrono::sys_days day) { return core::UtcTime{day.time_since_epoch()}; }

bool is_all_digits(std::string_view text) {
  return std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
}

/// The period of a year or a month, "2026" or "2026-05"; empty for any other text.
std::optional<StatedPeriod> year_or_month(std::string_view text) {
  const std::string_view digits = text.substr(0, digits_of_year);
  if (text.size() < digits_of_year || !is_all_digits(digits)) return std::nullopt;
  const std::chrono::year year{*whole_number(digits)};
  if (text.size() == digits_of_year)
    return StatedPeriod{midnight(year / std::chrono::January / 1),
                        midnight((year + std::chrono::years{1}) / std::chrono::January / 1)};
  const std::string_view month_digits = text.substr(digits_of_year + 1);
  if (text.size() != digits_of_month || text[digits_of_year] != '-' || !is_all_digits(month_digits))
    return std::nullopt;
  const std::chrono::year_month month{year,
                                      std::chrono::month{static_cast<unsigned>(*whole_number(month_digits))}};
  if (!month.ok()) return std::nullopt;
  return StatedPeriod{midnight(month / 1), midnight((month + std::chrono::months{1}) / 1)};
}

/// GDAL's spelling of a time converted to ISO 8601; other texts stay unchanged.
std::string iso_of_gdal(std::string_view text) {
  std::string iso{text};
  if (text.size() < day_length || text[4] != '/' || text[7] != '/') return iso;
  iso[4] = '-';
  iso[7] = '-';
  const std::string_view clock = text.substr(day_length);
  if (clock == " 00:00:00") return iso.substr(0, day_length);
  const std::size_t zone = clock.find_last_of("+-");
  if (zone != std::string_view::npos && clock.size() - zone == std::string_view{"+00"}.size()) iso += ":00";
  return iso;
}

}  // namespace

std::optional<StatedPeriod> stated_period(std::string_view text) {
  if (text.size() == compact_length && is_all_digits(text))
    return stated_period(std::string{text.substr(0, 4)} + "-" + std::string{text.substr(4, 2)} + "-" +
                         std::string{text.substr(6, 2)});
  if (text.size() < day_length) return year_or_month(text);
  const std::string iso = iso_of_gdal(text);
  const auto time = core::parse_iso8601(iso);
  if (!time) return std::nullopt;
  return StatedPeriod{*time, iso.size() == day_length ? *time + std::chrono::days{1} : *time};
}

std::optional<StatedInterval> stated_interval(std::string_view text) {
  if (const auto whole = stated_period(text)) return StatedInterval{whole->first, whole->last};
  for (const std::string_view between : {" to ", " until ", " - ", " – ", "/"}) {
    const std::size_t at = text.find(between);
    if (at == std::string_view::npos || text.find(between, at + 1) != std::string_view::npos) continue;
    const std::string begin = trimmed(text.substr(0, at));
    const std::string end = trimmed(text.substr(at + between.size()));
    const auto is_open = [](const std::string& side) { return side.empty() || side == ".."; };
    const auto first = stated_period(begin);
    const auto last = stated_period(end);
    if ((!first && !is_open(begin)) || (!last && !is_open(end)) || (!first && !last)) continue;
    StatedInterval interval;
    if (first) interval.first = first->first;
    if (last) interval.last = last->last;
    return interval;
  }
  return std::nullopt;
}

bool could_be_date(std::string_view text) {
  constexpr std::size_t unix_seconds = 10;  // number of digits since 2001; milliseconds have 13
  constexpr std::size_t unix_milliseconds = 13;
  const auto digits =
      static_cast<std::size_t>(std::ranges::count_if(text, [](char c) { return c >= '0' && c <= '9'; }));
  if (is_all_digits(text))
    return text.size() == compact_length ? stated_period(text).has_value()
                                         : text.size() == unix_seconds || text.size() == unix_milliseconds;
  if (digits < std::string_view{"1126"}.size()) return false;
  if (stated_interval(text)) return true;
  const bool of_figures = text.find_first_not_of("0123456789-/.:,TZ+ ") == std::string_view::npos;
  const auto strokes = std::ranges::count_if(text, [](char c) { return c == '-' || c == '/' || c == '.'; });
  if (of_figures) return strokes >= 2 && text.front() != '-';
  std::string letters;
  for (const char c : text)
    if (std::isalpha(static_cast<unsigned char>(c)) != 0) letters += c;
  const std::string word = lower(letters);
  return word.size() <= std::string_view{"septemberutc"}.size() &&
         std::ranges::any_of(month_beginnings,
                             [&](std::string_view month) { return contains_any(word, {month}); });
}

namespace {

/// "31.5.2026", "5/31/2026", "2026-05-31": three numbers, of which the first or the last is a year.
bool is_date_of_figures(std::string_view word) {
  const std::size_t first = word.find_first_of("./-");
  if (first == std::string_view::npos) return false;
  const std::size_t second = word.find(word[first], first + 1);
  if (second == std::string_view::npos) return false;
  const std::string_view parts[]{word.substr(0, first), word.substr(first + 1, second - first - 1),
                                 word.substr(second + 1)};
  const bool are_numbers =
      std::ranges::all_of(parts, [](std::string_view part) { return !part.empty() && is_all_digits(part); });
  return are_numbers && parts[1].size() <= 2 &&
         ((parts[0].size() == digits_of_year && parts[2].size() <= 2) ||
          (parts[0].size() <= 2 && parts[2].size() == digits_of_year));
}

}  // namespace

bool mentions_date(std::string_view text) {
  const auto is_month = [](const std::string& word) {
    return word.size() >= 3 &&
           std::ranges::any_of(months, [&](std::string_view month) { return month.starts_with(word); });
  };
  const auto is_day_or_year = [](const std::string& word) {
    return !word.empty() && word.size() <= digits_of_year && is_all_digits(word);
  };
  std::string before;
  std::string word;
  for (const char c : std::string{text} + " ") {
    const bool is_inside = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '/' ||
                           c == ':' || (c == '.' && !word.empty());
    if (is_inside) {
      word += c;
      continue;
    }
    while (!word.empty() && (word.back() == '.' || word.back() == ':')) word.pop_back();
    if (word.empty()) continue;
    const bool is_moment = word.size() >= compact_length && stated_period(word);
    word = lower(word);
    const bool beside_month =
        (is_month(word) && is_day_or_year(before)) || (is_month(before) && is_day_or_year(word));
    if (is_moment || beside_month || is_date_of_figures(word)) return true;
    before = std::exchange(word, {});
  }
  return false;
}

}  // namespace floeplan::ingest

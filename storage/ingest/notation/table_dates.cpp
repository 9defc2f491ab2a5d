#include "storage/ingest/notation/table_dates.hpp"

#include <charconv>
#include <chrono>

namespace floeplan::ingest {

std::optional<int> whole_number(std::string_view text) {
  int value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::optional<core::UtcTime> us_date(std::string_view text) {
  const std::size_t first = text.find('/');
  const std::size_t second = text.find('/', first + 1);
  if (first == std::string_view::npos || second == std::string_view::npos) return std::nullopt;
  const auto month = whole_number(text.substr(0, first));
  const auto day = whole_number(text.substr(first + 1, second - first - 1));
  auto year = whole_number(text.substr(second + 1));
  const std::size_t digits = text.size() - second - 1;
  if (!month || !day || !year || *month < 1 || *day < 1 || (digits != 2 && digits != 4)) return std::nullopt;
  if (digits == 2) *year += 2000;
  const std::chrono::year_month_day date{std::chrono::year{*year},
                                         std::chrono::month{static_cast<unsigned>(*month)},
                                         std::chrono::day{static_cast<unsigned>(*day)}};
  if (!date.ok()) return std::nullopt;
  return core::UtcTime{std::chrono::sys_days{date}.time_since_epoch()};
}

std::optional<core::UtcTime> year_and_day(std::string_view text) {
  const auto number = whole_number(text);
  if (!number || text.size() != 7) return std::nullopt;
  const std::chrono::year year{*number / 1000};
  const int day = *number % 1000;
  if (day < 1 || day > (year.is_leap() ? 366 : 365)) return std::nullopt;
  const std::chrono::sys_days first{year / std::chrono::January / 1};
  return core::UtcTime{(first + std::chrono::days{day - 1}).time_since_epoch()};
}

}  // namespace floeplan::ingest

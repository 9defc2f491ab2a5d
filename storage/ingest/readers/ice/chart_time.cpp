#include "storage/ingest/readers/ice/chart_time.hpp"

#include <chrono>
#include <cstdlib>

#include "storage/ingest/notation/text.hpp"

namespace floeplan::ingest {
namespace {

std::string digits_at(const std::string& name, std::size_t begin) {
  std::size_t end = begin;
  while (end < name.size() && is_digit(name[end])) ++end;
  return name.substr(begin, end - begin);
}

int number_at(const std::string& digits, std::size_t begin, std::size_t count) {
  return std::atoi(digits.substr(begin, count).c_str());
}

/// The time of texts: `date` is yyyymmdd; `clock` is hhmm or hhmmss, or empty.
std::optional<core::UtcTime> moment(const std::string& date, const std::string& clock) {
  const std::chrono::year_month_day day{std::chrono::year{number_at(date, 0, 4)},
                                        std::chrono::month{static_cast<unsigned>(number_at(date, 4, 2))},
                                        std::chrono::day{static_cast<unsigned>(number_at(date, 6, 2))}};
  constexpr std::chrono::year first_charts{1950};
  constexpr std::chrono::year last{2100};
  if (!day.ok() || day.year() < first_charts || day.year() > last) return std::nullopt;
  const int hour = clock.empty() ? 12 : number_at(clock, 0, 2);
  const int minute = clock.empty() ? 0 : number_at(clock, 2, 2);
  if (hour > 23 || minute > 59) return std::nullopt;
  return core::UtcTime{std::chrono::sys_days{day}.time_since_epoch()} +
         core::Seconds{3600.0 * hour + 60.0 * minute};
}

/// The time that a run of digits in a name, and the text after it, stands for.
std::optional<core::UtcTime> moment_of(const std::string& digits, const std::string& name, std::size_t end) {
  if (digits.size() == 12 || digits.size() == 14) return moment(digits, digits.substr(8));
  if (digits.size() != 8) return std::nullopt;
  const bool clock_follows = end < name.size() && (name[end] == 'T' || name[end] == 't');
  const std::string clock = clock_follows ? digits_at(name, end + 1) : "";
  return moment(digits, clock.size() == 4 || clock.size() == 6 ? clock : "");
}

}  // namespace

std::optional<core::UtcTime> time_in_name(const std::string& name) {
  std::optional<core::UtcTime> found;
  for (std::size_t i = 0; i < name.size();) {
    if (!is_digit(name[i])) {
      ++i;
      continue;
    }
    const std::string digits = digits_at(name, i);
    i += digits.size();
    const auto time = moment_of(digits, name, i);
    if (time && found && *time != *found) return std::nullopt;
    if (time) found = time;
  }
  return found;
}

}  // namespace floeplan::ingest

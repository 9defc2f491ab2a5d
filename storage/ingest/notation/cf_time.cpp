#include "storage/ingest/notation/cf_time.hpp"

#include <array>
#include <charconv>
#include <chrono>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

#include "engine/messages/ingest_time_messages.hpp"
#include "storage/ingest/notation/text.hpp"

namespace floeplan::ingest {
namespace {

constexpr double day_s = 86400.0;

struct Date {
  int year{};
  int month{};
  int day{};
};

struct Moment {
  Date date;
  double second_of_day{};
};

std::optional<double> unit_seconds(std::string_view unit) {
  if (unit == "s" || unit == "sec" || unit == "secs" || unit == "second" || unit == "seconds") return 1.0;
  if (unit == "ms" || unit == "msec" || unit == "millisecond" || unit == "milliseconds") return 0.001;
  if (unit == "min" || unit == "mins" || unit == "minute" || unit == "minutes") return 60.0;
  if (unit == "h" || unit == "hr" || unit == "hrs" || unit == "hour" || unit == "hours") return 3600.0;
  if (unit == "d" || unit == "day" || unit == "days") return day_s;
  if (unit == "week" || unit == "weeks") return 7.0 * day_s;
  return std::nullopt;
}

std::optional<CfCalendar> calendar_named(std::string_view name) {
  if (name.empty() || name == "standard" || name == "gregorian") return CfCalendar::standard;
  if (name == "proleptic_gregorian") return CfCalendar::proleptic_gregorian;
  if (name == "julian") return CfCalendar::julian;
  if (name == "noleap" || name == "no_leap" || name == "365_day") return CfCalendar::no_leap;
  if (name == "all_leap" || name == "366_day") return CfCalendar::all_leap;
  if (name == "360_day") return CfCalendar::days_360;
  return std::nullopt;
}

/// Reads numbers and signs from the beginning of a text.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : rest_{text} {}

  [[nodiscard]] bool done() const { return rest_.empty(); }
  [[nodiscard]] std::string_view rest() const { return rest_; }
  bool take(char c) {
    if (!rest_.starts_with(c)) return false;
    rest_.remove_prefix(1);
    return true;
  }
  void skip_blanks() {
    while (take(' ')) {
    }
  }
  std::optional<int> integer(std::size_t max_digits) {
    std::size_t n = 0;
    while (n < rest_.size() && n < max_digits && rest_[n] >= '0' && rest_[n] <= '9') ++n;
    int value{};
    const std::string_view digits = rest_.substr(0, n);
    if (digits.empty() || std::from_chars(digits.begin(), digits.end(), value).ec != std::errc{})
      return std::nullopt;
    rest_.remove_prefix(n);
    return value;
  }
  std::optional<double> decimal() {
    std::size_t n = 0;
    while (n < rest_.size() && ((rest_[n] >= '0' && rest_[n] <= '9') || rest_[n] == '.')) ++n;
    const auto value = parse_number(rest_.substr(0, n));
    if (value) rest_.remove_prefix(n);
    return value;
  }

 private:
  std::string_view rest_;
};

/// Zone in seconds east of Greenwich: nothing, "Z", "UTC", "GMT", "+1", "+01:00", "-0330".
std::optional<double> take_zone(Scanner& scan) {
  scan.skip_blanks();
  if (scan.done() || scan.rest() == "z" || scan.rest() == "utc" || scan.rest() == "gmt") return 0.0;
  const double sign = scan.take('-') ? -1.0 : (scan.take('+') ? 1.0 : 0.0);
  if (sign == 0.0) return std::nullopt;
  const auto hours = scan.integer(2);
  if (!hours || *hours > 14) return std::nullopt;
  int minutes = 0;
  scan.take(':');
  if (!scan.done()) {
    const auto given = scan.integer(2);
    if (!given || *given > 59 || !scan.done()) return std::nullopt;
    minutes = *given;
  }
  return sign * (*hours * 3600.0 + minutes * 60.0);
}

/// "2000-1-1", "1950-01-01T00:00:00.0Z", "2021-05-04 12:00:00 +00:00"; fields after the date may be missing.
std::optional<Moment> parse_reference(std::string_view text) {
  Scanner scan{text};
  Moment moment;
  const bool negative = scan.take('-');
  const auto year = scan.integer(4);
  if (!year || !scan.take('-')) return std::nullopt;
  const auto month = scan.integer(2);
  if (!month || !scan.take('-')) return std::nullopt;
  const auto day = scan.integer(2);
  if (!day) return std::nullopt;
  moment.date = {negative ? -*year : *year, *month, *day};
  if (scan.done()) return moment;

  if (!scan.take('t')) scan.skip_blanks();
  if (const auto hour = scan.integer(2)) {
    int minute = 0;
    double second = 0.0;
    if (scan.take(':')) {
      const auto given = scan.integer(2);
      if (!given) return std::nullopt;
      minute = *given;
      if (scan.take(':')) {
        const auto seconds = scan.decimal();
        if (!seconds) return std::nullopt;
        second = *seconds;
      }
    }
    if (*hour > 24 || minute > 59 || second >= 61.0) return std::nullopt;
    moment.second_of_day = *hour * 3600.0 + minute * 60.0 + second;
  }
  const auto zone = take_zone(scan);
  if (!zone) return std::nullopt;
  moment.second_of_day -= *zone;
  return moment;
}

std::chrono::year_month_day civil(const Date& date) {
  return {std::chrono::year{date.year}, std::chrono::month{static_cast<unsigned>(date.month)},
          std::chrono::day{static_cast<unsigned>(date.day)}};
}

/// Days since 1970-01-01 of a date in the Julian calendar. Source: Meeus, Astronomical Algorithms, chapter 7.
double julian_days(const Date& date) {
  const int shifted_year = date.month <= 2 ? date.year - 1 : date.year;
  const int shifted_month = date.month <= 2 ? date.month + 12 : date.month;
  const double julian_day = std::floor(365.25 * (shifted_year + 4716)) +
                            std::floor(30.6001 * (shifted_month + 1)) + date.day - 1524.5;
  return julian_day - 2440587.5;
}

constexpr std::array common_months{31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};

int month_length(CfCalendar calendar, int month) {
  if (calendar == CfCalendar::days_360) return 30;
  if (month == 2 && calendar == CfCalendar::all_leap) return 29;
  return common_months[static_cast<std::size_t>(month - 1)];
}

int year_length(CfCalendar calendar) {
  if (calendar == CfCalendar::days_360) return 360;
  return calendar == CfCalendar::all_leap ? 366 : 365;
}

/// Days of a date since 1970-01-01 (real calendars) or since year 0 of the model's calendar; nullopt: no such
/// date.
std::optional<double> day_number(CfCalendar calendar, const Date& date) {
  if (date.month < 1 || date.month > 12 || date.day < 1) return std::nullopt;
  switch (calendar) {
    case CfCalendar::standard: {
      const std::tuple named{date.year, date.month, date.day};
      const bool before_reform = named < std::tuple{1582, 10, 15};
      // the reform skipped these days
      if (before_reform && named > std::tuple{1582, 10, 4}) return std::nullopt;
      return day_number(before_reform ? CfCalendar::julian : CfCalendar::proleptic_gregorian, date);
    }
    case CfCalendar::proleptic_gregorian:
      if (!civil(date).ok()) return std::nullopt;
      return static_cast<double>(std::chrono::sys_days{civil(date)}.time_since_epoch().count());
    case CfCalendar::julian:
      if (date.day >
          (date.month == 2 && date.year % 4 == 0 ? 29 : month_length(CfCalendar::no_leap, date.month)))
        return std::nullopt;
      return julian_days(date);
    case CfCalendar::no_leap:
    case CfCalendar::all_leap:
    case CfCalendar::days_360: {
      if (date.day > month_length(calendar, date.month)) return std::nullopt;
      double days = static_cast<double>(date.year) * year_length(calendar) + date.day - 1;
      for (int month = 1; month < date.month; ++month) days += month_length(calendar, month);
      return days;
    }
  }
  return std::nullopt;
}

/// The starting date's year in a count with a year 0: the historical year -4713 (4713 BC) becomes -4712.
/// nullopt: programs do not agree which year is meant.
std::optional<int> year_with_zero(CfCalendar calendar, const Date& date) {
  switch (calendar) {
    case CfCalendar::standard:
    case CfCalendar::julian:
      if (date.year == 0) return std::nullopt;
      return date.year < 0 ? date.year + 1 : date.year;
    case CfCalendar::proleptic_gregorian: {
      if (date.year >= 0) return date.year;
      // Beginning of the Julian Day, in counts with and without a year 0. Other dates of these years do not
      // show which count is used.
      if (date.month != 11 || date.day != 24 || (date.year != -4713 && date.year != -4714))
        return std::nullopt;
      return -4713;
    }
    case CfCalendar::no_leap:
    case CfCalendar::all_leap:
    case CfCalendar::days_360: return date.year;
  }
  return std::nullopt;
}

/// The date with this day number in a model's calendar.
Date model_date(CfCalendar calendar, double day) {
  const double year = std::floor(day / year_length(calendar));
  int day_of_year = static_cast<int>(day - year * year_length(calendar));
  Date date{static_cast<int>(year), 1, 1};
  while (day_of_year >= month_length(calendar, date.month))
    day_of_year -= month_length(calendar, date.month++);
  date.day = day_of_year + 1;
  return date;
}

/// The Julian calendar's date on a day, given as days since 1970-01-01, if the Gregorian calendar has this
/// date too.
std::optional<Date> julian_date(double day) {
  // days that the Julian date lags behind the Gregorian one, from the year 1 to 2100
  for (int behind = -2; behind <= 13; ++behind) {
    const std::chrono::year_month_day date{
        std::chrono::sys_days{std::chrono::days{static_cast<int>(day) - behind}}};
    const Date named{static_cast<int>(date.year()), static_cast<int>(static_cast<unsigned>(date.month())),
                     static_cast<int>(static_cast<unsigned>(date.day()))};
    if (julian_days(named) == day) return named;
  }
  return std::nullopt;
}

}  // namespace

Checked<CfTime> CfTime::parse(std::string_view units, std::string_view calendar) {
  const std::string quoted = "\"" + std::string{units} + "\"";
  const std::string text = lower(trimmed(units));
  const std::size_t since = text.find(" since ");
  if (since == std::string::npos)
    return refuse(messages::ingest_time_message<"time-unit-without-date">(quoted));

  CfTime time;
  time.text_ = quoted + (calendar.empty() ? "" : " in the calendar \"" + std::string{calendar} + "\"");
  const auto unit_s = unit_seconds(trimmed(text.substr(0, since)));
  if (!unit_s) return refuse(messages::ingest_time_message<"time-unit-unknown">(quoted));
  const auto known = calendar_named(lower(trimmed(calendar)));
  if (!known) return refuse(messages::ingest_time_message<"calendar-unknown">(std::string{calendar}));

  auto reference = parse_reference(trimmed(text.substr(since + 7)));
  if (reference) {
    const auto year = year_with_zero(*known, reference->date);
    if (!year) return refuse(messages::ingest_time_message<"year-zero-unclear">(time.text_));
    reference->date.year = *year;
  }
  const auto day = reference ? day_number(*known, reference->date) : std::nullopt;
  if (!day) return refuse(messages::ingest_time_message<"starting-date-unreadable">(time.text_));

  time.calendar_ = *known;
  time.unit_s_ = *unit_s;
  time.before_year_1_ = reference->date.year < 1;
  time.epoch_s_ = *day * day_s + reference->second_of_day;
  return time;
}

bool CfTime::is_model_calendar() const {
  return calendar_ == CfCalendar::no_leap || calendar_ == CfCalendar::all_leap ||
         calendar_ == CfCalendar::days_360;
}

bool CfTime::is_julian() const { return calendar_ == CfCalendar::julian && !before_year_1_; }

bool is_possible_time(double unix_s) {
  constexpr double year_1800_s = -5364662400.0;
  constexpr double year_2200_s = 7258118400.0;
  return unix_s >= year_1800_s && unix_s < year_2200_s;
}

Checked<core::UtcTime> CfTime::at(double value) const {
  const std::string quoted = number(value, 15) + " " + text_;
  if (!std::isfinite(value)) return refuse(messages::ingest_time_message<"step-without-time">(quoted));
  double seconds = std::round((epoch_s_ + value * unit_s_) * 1000.0) / 1000.0;
  if (std::abs(seconds) > 1e12) return refuse(messages::ingest_time_message<"time-out-of-range">(quoted));

  if (is_julian()) {
    const double day = std::floor(seconds / day_s);
    const auto date = julian_date(day);
    if (!date) return refuse(messages::ingest_time_message<"leap-day-of-no-year">(quoted));
    seconds += (*day_number(CfCalendar::proleptic_gregorian, *date) - day) * day_s;
  }
  if (is_model_calendar()) {
    const double day = std::floor(seconds / day_s);
    const Date date = model_date(calendar_, day);
    if (!civil(date).ok())
      return refuse(messages::ingest_time_message<"date-of-model-calendar">(
          quoted,
          std::to_string(date.year) + "-" + std::to_string(date.month) + "-" + std::to_string(date.day)));
    seconds = *day_number(CfCalendar::proleptic_gregorian, date) * day_s + (seconds - day * day_s);
  }

  if (!is_possible_time(seconds)) return refuse(messages::ingest_time_message<"time-out-of-range">(quoted));
  return core::from_unix_seconds(seconds);
}

}  // namespace floeplan::ingest

#include "engine/core/utc_text.hpp"

#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdio>

namespace floeplan::core {
namespace {

/// Reads text from left to right. A reader that fails leaves the position unchanged.
class Reader {
 public:
  explicit Reader(std::string_view text) : rest_{text} {}

  [[nodiscard]] bool at_end() const { return rest_.empty(); }
  [[nodiscard]] bool at(char wanted) const { return rest_.starts_with(wanted); }

  bool take(char wanted) {
    if (!at(wanted)) return false;
    rest_.remove_prefix(1);
    return true;
  }

  std::optional<int> digits(std::size_t count) {
    if (rest_.size() < count) return std::nullopt;
    int value = 0;
    for (const char c : rest_.substr(0, count)) {
      if (c < '0' || c > '9') return std::nullopt;
      value = value * 10 + (c - '0');
    }
    rest_.remove_prefix(count);
    return value;
  }

  /// An unsigned decimal number with at most nine digits before the point.
  std::optional<double> number() {
    std::size_t length = 0;
    while (length < rest_.size() &&
           (std::isdigit(static_cast<unsigned char>(rest_[length])) != 0 || rest_[length] == '.')) {
      ++length;
    }
    double value = 0.0;
    const char* const begin = rest_.data();
    const auto [end, error] = std::from_chars(begin, begin + length, value);
    if (length == 0 || error != std::errc{} || end != begin + length || value > 999'999'999.0) {
      return std::nullopt;
    }
    rest_.remove_prefix(length);
    return value;
  }

 private:
  std::string_view rest_;
};

std::optional<UtcTime> midnight(int year, int month, int day) {
  const std::chrono::year_month_day date{std::chrono::year{year},
                                         std::chrono::month{static_cast<unsigned>(month)},
                                         std::chrono::day{static_cast<unsigned>(day)}};
  if (!date.ok()) return std::nullopt;
  return UtcTime{std::chrono::sys_days{date}};
}

/// The time zone, as seconds east of Greenwich.
std::optional<Seconds> zone(Reader& reader) {
  if (reader.take('Z') || reader.take('z')) return Seconds{0.0};
  const bool west = reader.take('-');
  if (!west && !reader.take('+')) return std::nullopt;
  const auto hours = reader.digits(2);
  reader.take(':');
  const auto minutes = reader.digits(2);
  if (!hours || !minutes || *hours > 23 || *minutes > 59) return std::nullopt;
  const Seconds offset{*hours * 3600.0 + *minutes * 60.0};
  return west ? -offset : offset;
}

}  // namespace

std::string iso8601(UtcTime time) {
  const auto whole = std::chrono::round<std::chrono::seconds>(time);
  const auto day = std::chrono::floor<std::chrono::days>(whole);
  const std::chrono::year_month_day date{day};
  const std::chrono::hh_mm_ss clock{whole - day};

  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%04d-%02u-%02uT%02ld:%02ld:%02ldZ", static_cast<int>(date.year()),
                static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()),
                static_cast<long>(clock.hours().count()), static_cast<long>(clock.minutes().count()),
                static_cast<long>(clock.seconds().count()));
  return text.data();
}

std::optional<UtcTime> parse_iso8601(std::string_view text) {
  Reader reader{text};
  const auto year = reader.digits(4);
  if (!year || !reader.take('-')) return std::nullopt;
  const auto month = reader.digits(2);
  if (!month || !reader.take('-')) return std::nullopt;
  const auto day = reader.digits(2);
  if (!day) return std::nullopt;
  const auto date = midnight(*year, *month, *day);
  if (!date || reader.at_end()) return date;

  if (!reader.take('T') && !reader.take('t') && !reader.take(' ')) return std::nullopt;
  const auto hours = reader.digits(2);
  if (!hours || !reader.take(':')) return std::nullopt;
  const auto minutes = reader.digits(2);
  if (!minutes) return std::nullopt;
  double seconds = 0.0;
  if (reader.take(':')) {
    const auto whole = reader.digits(2);
    const auto fraction = reader.at('.') ? reader.number() : 0.0;
    if (!whole || !fraction) return std::nullopt;
    seconds = *whole + *fraction;
  }
  if (*hours > 23 || *minutes > 59 || seconds >= 60.0) return std::nullopt;

  const auto east_of_greenwich = zone(reader);
  if (!east_of_greenwich || !reader.at_end()) return std::nullopt;
  return *date + Seconds{*hours * 3600.0 + *minutes * 60.0 + seconds} - *east_of_greenwich;
}

std::optional<Seconds> parse_iso8601_duration(std::string_view text) {
  struct Part {
    char letter;
    double seconds;
  };
  constexpr std::array date_parts{Part{'W', 7 * 86400.0}, Part{'D', 86400.0}};
  constexpr std::array time_parts{Part{'H', 3600.0}, Part{'M', 60.0}, Part{'S', 1.0}};

  Reader reader{text};
  if (!reader.take('P')) return std::nullopt;
  double total = 0.0;
  int parts = 0;
  const auto read_parts = [&](const auto& allowed) {
    std::size_t next = 0;
    while (auto number = reader.number()) {
      while (next < allowed.size() && !reader.take(allowed[next].letter)) ++next;
      if (next == allowed.size()) return false;
      total += *number * allowed[next].seconds;
      ++next;
      ++parts;
    }
    return true;
  };
  if (!read_parts(date_parts)) return std::nullopt;
  if (reader.take('T')) {
    const int before = parts;
    if (!read_parts(time_parts) || parts == before) return std::nullopt;
  }
  if (parts == 0 || !reader.at_end()) return std::nullopt;
  return Seconds{total};
}

std::string hours_minutes(Seconds time) {
  const long long minutes = std::llround(time.count() / 60.0);
  if (minutes < 60) return std::to_string(minutes) + " min";
  const std::string rest = std::to_string(minutes % 60);
  return std::to_string(minutes / 60) + " h " + (rest.size() < 2 ? "0" : "") + rest + " min";
}

}  // namespace floeplan::core

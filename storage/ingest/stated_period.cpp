#include "storage/ingest/stated_period.hpp"

#include <algorithm>
#include <chrono>
#include <string>

#include "engine/core/utc_text.hpp"
#include "storage/ingest/table_dates.hpp"

namespace floeplan::ingest {
namespace {

constexpr std::size_t year_length = std::string_view{"2026"}.size();
constexpr std::size_t month_length = std::string_view{"2026-05"}.size();
constexpr std::size_t day_length = std::string_view{"2026-05-01"}.size();

core::UtcTime midnight(std::chrono::sys_days day) { return core::UtcTime{day.time_since_epoch()}; }

bool is_all_digits(std::string_view text) {
  return std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
}

/// Of "2026" or "2026-05".
std::optional<StatedPeriod> year_or_month(std::string_view text) {
  const std::string_view digits = text.substr(0, year_length);
  if (text.size() < year_length || !is_all_digits(digits)) return std::nullopt;
  const std::chrono::year year{*whole_number(digits)};
  if (text.size() == year_length)
    return StatedPeriod{midnight(year / std::chrono::January / 1),
                        midnight((year + std::chrono::years{1}) / std::chrono::January / 1)};
  const std::string_view month_digits = text.substr(year_length + 1);
  if (text.size() != month_length || text[year_length] != '-' || !is_all_digits(month_digits))
    return std::nullopt;
  const std::chrono::year_month month{year,
                                      std::chrono::month{static_cast<unsigned>(*whole_number(month_digits))}};
  if (!month.ok()) return std::nullopt;
  return StatedPeriod{midnight(month / 1), midnight((month + std::chrono::months{1}) / 1)};
}

/// A time as GDAL spells it, as ISO 8601; other texts as they are.
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
  if (text.size() < day_length) return year_or_month(text);
  const std::string iso = iso_of_gdal(text);
  const auto time = core::parse_iso8601(iso);
  if (!time) return std::nullopt;
  return StatedPeriod{*time, iso.size() == day_length ? *time + std::chrono::days{1} : *time};
}

}  // namespace floeplan::ingest

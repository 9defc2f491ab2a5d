#pragma once

#include <string>
#include <string_view>

#include "engine/core/units.hpp"
#include "storage/ingest/common/refusal.hpp"

namespace floeplan::ingest {

/// Whether seconds since 1970-01-01T00:00:00Z lie within the years 1800 to 2199; false for NaN. Chosen: data of no sea are
/// older, and no forecast reaches further.
[[nodiscard]] bool is_possible_time(double unix_s);

/// Calendars of the CF conventions, section 4.4.1.
enum class CfCalendar { standard, proleptic_gregorian, julian, no_leap, all_leap, days_360 };

/// Decodes the time axis of a NetCDF file: "<unit> since <date>" in a calendar.
/// Units    weeks, days, hours, minutes, seconds, milliseconds; months and years are refused: their length
///          varies
/// Edges    a date in a model's own calendar, or in the Julian one, becomes the same date in the Gregorian
///          calendar; a date that does not exist there (30 February, 29 February of a common year) is
///          refused. "standard" is Julian before 15 October 1582. Starting dates before year 1: "standard"
///          and "julian" have no year 0; their year -4713 is 4713 BC, and times from there count days (the
///          Julian Day), which become Gregorian dates. "proleptic_gregorian" has a year 0, as ISO 8601 does;
///          of its earlier dates only the beginning of the Julian Day is accepted, because programs differ
/// Source   CF conventions 1.8, section 4.4; UDUNITS-2 for the spelling of the reference date and its years
class CfTime {
 public:
  /// Errors  the texts cannot be understood; the messages quote them
  [[nodiscard]] static Checked<CfTime> parse(std::string_view units, std::string_view calendar);

  /// The time of a value, rounded to the millisecond. Refuses non-finite values and times outside the years
  /// 1800 to 2200.
  [[nodiscard]] Checked<core::UtcTime> at(double value) const;
  /// True if the calendar is not Gregorian or Julian, so that its dates drift against the sun and the moon.
  [[nodiscard]] bool is_model_calendar() const;
  /// True if the file states the Julian calendar and counts from year 1 or later. Producers of today mean its
  /// dates, not its days: by days, files of OSCAR and of GFDL's models would lie 13 days in the future.
  [[nodiscard]] bool is_julian() const;

 private:
  CfCalendar calendar_{CfCalendar::standard};
  double unit_s_{1.0};
  // seconds since 1970-01-01 for real calendars, since year 0 of the model's own calendar for the
  double epoch_s_{};
  // others
  bool before_year_1_{false};  // whether the starting date is before year 1
  std::string text_;           // the text of the file, for messages
};

}  // namespace floeplan::ingest

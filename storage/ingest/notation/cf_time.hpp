#pragma once

#include <string>
#include <string_view>

#include "engine/core/units.hpp"
#include "storage/ingest/common/refusal.hpp"

namespace floeplan::ingest {

/// Calendars of the CF conventions, section 4.4.1.
enum class CfCalendar { standard, proleptic_gregorian, julian, no_leap, all_leap, days_360 };

/// Decodes the time axis of a NetCDF file: "<unit> since <date>" in a calendar.
/// Units    weeks, days, hours, minutes, seconds, milliseconds; months and years are refused: their length
///          varies
/// Edges    a date in a model's own calendar, or in the Julian one, becomes the same date in ours; one that ours lacks
///          (30 February, 29 February of a common year) is refused. "standard" is Julian before 15 October 1582.
///          Starting dates before year 1: "standard" and "julian" have no year 0, -4713 is 4713 BC, and what counts from
///          there counts days (the Julian Day), whose dates are ours; "proleptic_gregorian" has a year 0, as ISO 8601
///          does, and of its years before that only the beginning of the Julian Day is known, because programs differ
/// Source   CF conventions 1.8, section 4.4; UDUNITS-2 for the spelling of the reference date and its years
class CfTime {
 public:
  /// Errors  the file's own text is quoted
  [[nodiscard]] static Checked<CfTime> parse(std::string_view units, std::string_view calendar);

  /// Rounded to the millisecond. Refuses what is not finite and what lies outside the years 1800 to 2200.
  [[nodiscard]] Checked<core::UtcTime> at(double value) const;
  /// True when the calendar is not the one the world uses, so dates drift against the sun and the moon.
  [[nodiscard]] bool is_model_calendar() const;
  /// True when the file states the Julian calendar and counts from year 1 or later. Today's producers mean
  /// the dates of that calendar, not its days: by its days OSCAR and models of GFDL would lie 13 days in the future.
  [[nodiscard]] bool is_julian() const;

 private:
  CfCalendar calendar_{CfCalendar::standard};
  double unit_s_{1.0};
  double epoch_s_{};  // since 1970-01-01 for real calendars, since year 0 of the model's own calendar for the
                      // others
  bool before_year_1_{false};  // of the starting date
  std::string text_;           // as the file has it, for messages
};

}  // namespace floeplan::ingest

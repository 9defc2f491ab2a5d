#pragma once

#include <optional>
#include <string_view>

#include "engine/core/units.hpp"

namespace floeplan::ingest {

/// The period that a text of a time covers.
struct StatedPeriod {
  core::UtcTime first;
  core::UtcTime last;  // equal to `first` for a moment
};

/// Reads a moment with its zone in ISO 8601, or a whole day, month or year in UTC: "2026-05-01T06:00:00Z",
/// "2026-05-01", "2026-05", "2026"; "20260501" as in S-57. Also GDAL's spelling: "2026/05/01", "2026/05/01
/// 06:00:00+00". GDAL turns a day into its midnight without a zone; such a midnight counts as the whole day.
/// Outside  nullopt for every other text, also for a time of day without a zone
/// Source   XML Schema 1.1 part 2, dateTime, date, gYearMonth and gYear, as used in OGC KML 2.2 (07-147r2),
///          16;
///          GDAL's OGRFeature::GetFieldAsString
[[nodiscard]] std::optional<StatedPeriod> stated_period(std::string_view text);

/// The period from one such text to another, separated by a slash, a dash between blanks, "to" or "until":
/// "2026-05-01/2026-05-31". A single text covers its own period; ".." or nothing beside the slash means
/// unbounded.
struct StatedInterval {
  std::optional<core::UtcTime> first;
  std::optional<core::UtcTime> last;
};
[[nodiscard]] std::optional<StatedInterval> stated_interval(std::string_view text);

/// Whether a text looks like a date in any spelling: "31.5.2026", "5/31/26", "1 May 2026", "1777593600000".
[[nodiscard]] bool could_be_date(std::string_view text);

/// Whether free text contains a date: "closed from 1 May 2026", "until 31.5.2026".
/// Edges    a year alone does not count
[[nodiscard]] bool mentions_date(std::string_view text);

}  // namespace floeplan::ingest

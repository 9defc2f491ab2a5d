#pragma once

#include <optional>
#include <string_view>

#include "engine/core/units.hpp"

namespace floeplan::ingest {

/// What a text of a time spans.
struct StatedPeriod {
  core::UtcTime first;
  core::UtcTime last;  // of a moment the same
};

/// A moment with its zone in ISO 8601, or a whole day, month or year in UTC: "2026-05-01T06:00:00Z", "2026-05-01",
/// "2026-05", "2026"; "20260501" as S-57 has it. Also as GDAL spells times: "2026/05/01", "2026/05/01 06:00:00+00"; its midnight without a zone is
/// what it makes of a day.
/// Outside  nothing for anything else, also for a time of day without a zone
/// Source   XML Schema 1.1 part 2, dateTime, date, gYearMonth and gYear, as OGC KML 2.2 (07-147r2), 16 has them;
///          GDAL's OGRFeature::GetFieldAsString
[[nodiscard]] std::optional<StatedPeriod> stated_period(std::string_view text);

/// What two such texts span with a stroke, a dash between blanks, "to" or "until" between them: "2026-05-01/2026-05-31".
/// One text alone spans what it does, and ".." or nothing beside the stroke is unbounded.
struct StatedInterval {
  std::optional<core::UtcTime> first;
  std::optional<core::UtcTime> last;
};
[[nodiscard]] std::optional<StatedInterval> stated_interval(std::string_view text);

/// Whether a text looks like a date in any spelling: "31.5.2026", "5/31/26", "1 May 2026", "1777593600000".
[[nodiscard]] bool could_be_date(std::string_view text);

/// Whether free text holds a date among its words: "closed from 1 May 2026", "until 31.5.2026".
/// Edges    a year alone is none
[[nodiscard]] bool mentions_date(std::string_view text);

}  // namespace floeplan::ingest

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
/// "2026-05", "2026". Also as GDAL spells times: "2026/05/01", "2026/05/01 06:00:00+00"; its midnight without a zone is
/// what it makes of a day.
/// Outside  nothing for anything else, also for a time of day without a zone
/// Source   XML Schema 1.1 part 2, dateTime, date, gYearMonth and gYear, as OGC KML 2.2 (07-147r2), 16 has them;
///          GDAL's OGRFeature::GetFieldAsString
[[nodiscard]] std::optional<StatedPeriod> stated_period(std::string_view text);

}  // namespace floeplan::ingest

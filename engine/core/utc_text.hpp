#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "engine/core/units.hpp"

namespace floeplan::core {

/// ISO 8601 text of an instant, UTC with `Z`: "2026-11-20T06:00:00Z", rounded to the nearest second.
[[nodiscard]] std::string iso8601(UtcTime time);

/// Parses an instant in ISO 8601 / RFC 3339: date, 'T' or blank, hh:mm[:ss[.fff]], then Z or +-hh:mm.
/// Edges    a date alone means 00:00:00Z; a time without a zone is refused, because a guess can be wrong by
///          hours
/// Outside  nullopt for anything else, for impossible dates (30 February) and for leap seconds
[[nodiscard]] std::optional<UtcTime> parse_iso8601(std::string_view text);

/// ISO 8601 duration of days and time ("PT1H", "P1DT30M", "PT90S"); no years or months, which have no fixed
/// length.
[[nodiscard]] std::optional<Seconds> parse_iso8601_duration(std::string_view text);

/// A duration of at least zero for people, rounded to whole minutes: "2 h 40 min", "12 min".
[[nodiscard]] std::string hours_minutes(Seconds time);

}  // namespace floeplan::core

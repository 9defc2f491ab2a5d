#pragma once

#include <optional>
#include <string_view>

#include "engine/core/units.hpp"

namespace floeplan::ingest {

/// The number, if the whole text is a whole number.
[[nodiscard]] std::optional<int> whole_number(std::string_view text);
/// "11/7/2014" (month first), or "08/16/26" for a year of this century: the beginning of the day, UTC.
[[nodiscard]] std::optional<core::UtcTime> us_date(std::string_view text);
/// "2014342": the beginning of the 342nd day of 2014, UTC.
[[nodiscard]] std::optional<core::UtcTime> year_and_day(std::string_view text);

}  // namespace floeplan::ingest

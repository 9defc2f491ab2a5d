#pragma once

#include "engine/messages/kind.hpp"

/// Messages to the pilot about the time coordinates of a file.
namespace floeplan::messages {

inline constexpr auto ingest_time_kinds = std::to_array<Kind>({
    {.code = "time-unit-without-date",
     .rank = Rank::caution,
     .text = "the time axis has the unit {unit}, which names no starting date, so its times are not known",
     .hint = "Ask the producer for a file with units like \"hours since 2000-01-01\"",
     .slots = {{{"unit", "\"hours\""}}}},
    {.code = "time-unit-unknown",
     .rank = Rank::caution,
     .text = "the time unit in {unit} is not known or has no fixed length",
     .hint = "Convert the times to weeks, days, hours, minutes or seconds",
     .slots = {{{"unit", "\"months since 2000-01-01\""}}}},
    {.code = "calendar-unknown",
     .rank = Rank::caution,
     .text = "the calendar \"{calendar}\" is not known",
     .hint = "Convert the times to the calendar \"standard\"",
     .slots = {{{"calendar", "lunar"}}}},
    {.code = "year-zero-unclear",
     .rank = Rank::caution,
     .text = "the year of the starting date in {unit} is unclear, because some programs count a year 0 "
             "before year 1 and others do not. The times may therefore be a year wrong",
     .hint = "Ask the producer for a starting date after year 1, such as \"1970-01-01\"",
     .slots = {{{"unit", "\"days since 0000-01-01\""}}}},
    {.code = "starting-date-unreadable",
     .rank = Rank::caution,
     .text = "the starting date in {unit} cannot be read",
     .hint = "Correct it to a date such as \"2000-01-01 00:00:00\"",
     .slots = {{{"unit", "\"days since yesterday\""}}}},
    {.code = "step-without-time",
     .rank = Rank::caution,
     .text = "a time is missing ({unit}), but every step needs a time",
     .hint = "Ask the producer for a complete file",
     .slots = {{{"unit", "\"days since 2000-01-01\""}}}},
    {.code = "time-out-of-range",
     .rank = Rank::caution,
     .text = "the time {time} is not within the years 1800 to 2200. Its unit or its starting date is wrong",
     .hint = "Ask the producer",
     .slots = {{{"time", "\"9e9 days since 2000-01-01\""}}}},
    {.code = "leap-day-of-no-year",
     .rank = Rank::caution,
     .text = "the time {time} falls on a 29 February that does not exist in today's calendar",
     .hint = "Convert the times to the standard calendar",
     .slots = {{{"time", "\"59 days since 1900-01-01\""}}}},
    {.code = "date-of-model-calendar",
     .rank = Rank::caution,
     .text = "the time {time} is a date that only the model's calendar has ({date}), so it stands for no "
             "real day",
     .hint = "Convert the times to the standard calendar",
     .slots = {{{"time", "\"59 days since 1900-01-01\""}, {"date", "1900-2-30"}}}},
});

/// Makes the message with this code. `given`: its values, in the order of its slots in the table above.
template <Code code, class... Given>
[[nodiscard]] Message ingest_time_message(const Given&... given) {
  return make_message<ingest_time_kinds, code>(given...);
}

}  // namespace floeplan::messages

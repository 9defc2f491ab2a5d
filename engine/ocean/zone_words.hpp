#pragma once

#include <string_view>

namespace floeplan::ocean {

/// What an attribute says of a zone, by its name.
enum class AttributeMeaning {
  nothing,
  record,  // who wrote it down, and when: nothing of the zone
  zone_name,
  kind,          // the rule, whatever it holds
  perhaps_kind,  // a type or class of the zone: the rule, where it holds one
  from,          // the rule's first moment
  until,         // its last one
  period,        // both
  unclear_period,  // of the beginning or the end of something: where it holds a date the author must say of what
  some_date,       // of what it does not say: no period, which is told where it could be taken for one
  top,
  bottom,
  depths,         // both, where it holds a range
  unclear_depth,  // of something, such as the sea bed
};

/// Understands the name of an attribute by its words, which are told apart at blanks, underscores, other signs, figures
/// and humps ("ValidTo"), and where known words are written together ("STARTDATE"). A shapefile cuts names after ten
/// letters, so the last word of such a name may be the beginning of one.
/// The words  rule, kind, type, class... with or without zone, area...; begin, start, from, since, effective... and end,
///            until, to, expires... with or without date, time, valid...; top, upper, bottom, lower, or min, max, from, to
///            with depth
/// Edges      words of the record count first: created_date, last_edited_date and beginLifespanVersion are no period. The
///            beginning or end of something unknown (project_end, start_lat) is unclear
/// Source     names as ArcGIS (editor tracking), INSPIRE, S-57 (DATSTA, DATEND, PERSTA, PEREND), the World Database on
///            Protected Areas and national services of marine zones have them
[[nodiscard]] AttributeMeaning meaning_of_attribute(std::string_view name);

/// The unit of length among the words of a name, as "ft" in "top_ft"; empty: none.
[[nodiscard]] std::string_view unit_in_attribute(std::string_view name);

}  // namespace floeplan::ocean

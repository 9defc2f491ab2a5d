#pragma once

#include <string_view>

namespace floeplan::ocean {

/// Meaning of a zone's attribute, derived from its name.
enum class AttributeMeaning {
  nothing,
  record,  // who recorded it, and when: nothing about the zone
  zone_name,
  kind,            // the rule, whatever its value
  perhaps_kind,    // type or class of the zone: the rule, if the value is one
  from,            // begin of the rule's period
  until,           // end of the rule's period
  period,          // both
  unclear_period,  // begin or end of something unnamed: if it holds a date, the author must say of what
  some_date,       // a date without a meaning: not a period, but reported where it could be taken for one
  top,
  bottom,
  depths,         // both, if the value is a range
  unclear_depth,  // of something else, such as the sea bed
};

/// Derives the meaning of an attribute from the words of its name. Words are separated at blanks,
/// underscores, other signs, digits and capitals ("ValidTo"), and known words are also found if written
/// together ("STARTDATE"). A shapefile cuts names after ten letters, so the last word of such a name may be
/// incomplete.
/// Words      rule, kind, type, class... with or without zone, area...; begin, start, from, since,
///            effective... and end, until, to, expires... with or without date, time, valid...; top, upper,
///            bottom, lower, or min, max, from, to with depth
/// Edges      Words about the record count first: created_date, last_edited_date and beginLifespanVersion are
///            not a period. The beginning or end of something unknown (project_end, start_lat) is unclear
/// Source     names used by ArcGIS (editor tracking), INSPIRE, S-57 (DATSTA, DATEND, PERSTA, PEREND), the
///            World Database on Protected Areas and national services of marine zones
[[nodiscard]] AttributeMeaning meaning_of_attribute(std::string_view name);

/// The unit of length in an attribute's name, such as "ft" in "top_ft"; empty: none.
[[nodiscard]] std::string_view unit_in_attribute(std::string_view name);

}  // namespace floeplan::ocean

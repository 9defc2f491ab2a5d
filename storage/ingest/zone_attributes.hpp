#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/ocean/zone.hpp"

class OGRFeature;

namespace floeplan::ingest {

/// What the attributes of a feature say of a zone, and all that is wrong with them.
struct ZoneAttributes {
  ocean::Zone zone;  // without its area
  std::vector<std::string> faults;
};

/// Reads the attributes by their names, of which case, blanks and punctuation do not count:
///   kind (rule, zone_kind)                 no_go (no-go, keep_out, exclusion), stay_in (keep_in, inclusion)
///   name (title, label)
///   from (valid_from, start, begin)        the rule's first moment; without it: since ever
///   until (valid_until, valid_to, to, end, stop, expires)   its last one; without it: for ever
///   top_m (top, min_depth)                 metres below the surface, default 0
///   bottom_m (bottom, max_depth)           default: to the sea bed
/// also those that a shapefile cuts after ten letters, and start_time, end_time, depth_min and depth_max. Times
/// are read as `stated_period` does: a day, a month or a year is the whole of it. Of a KML file the time span of the
/// folders around holds too, the narrower of both. An empty attribute is as none.
/// `kind_of_others`: the rule of a feature that states none.
[[nodiscard]] ZoneAttributes read_zone_attributes(const OGRFeature& feature,
                                                  std::optional<ocean::ZoneKind> kind_of_others);

/// Whether the feature states the rule of a zone.
[[nodiscard]] bool states_zone_kind(const OGRFeature& feature);

/// "no-go", "keep out" and the like, in any spelling that is accepted.
[[nodiscard]] std::optional<ocean::ZoneKind> zone_kind_of(const std::string& text);

}  // namespace floeplan::ingest

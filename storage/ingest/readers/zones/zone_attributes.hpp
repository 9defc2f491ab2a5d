#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/ocean/zone.hpp"
#include "engine/ocean/zone_words.hpp"

class OGRFeature;

namespace floeplan::ingest {

/// What the names of a file's attributes mean, each understood once.
class AttributeMeanings {
 public:
  [[nodiscard]] ocean::AttributeMeaning of(const std::string& name);

 private:
  std::map<std::string, ocean::AttributeMeaning> known_;
};

/// What an attribute seems to say of a zone and is not obeyed.
struct Unheeded {
  std::string attribute;
  messages::Message told;
};

/// What the attributes of a feature say of a zone, and all that is wrong with them.
struct ZoneAttributes {
  ocean::Zone zone;  // without its area
  Messages faults;
  std::vector<Unheeded> unheeded;
};

/// Reads the attributes by the words of their names, as `ocean::meaning_of_attribute` understands them.
/// Rule     no_go (no-go, keep_out, exclusion), stay_in (keep_in, inclusion) under any name but the zone's: what the file
///          says is stronger than `kind_of_others`, the rule of a feature that states none
/// Times    as `stated_period` and `stated_interval` read them: a day, a month or a year is the whole of it; "permanent"
///          and the like have no end. Of a KML file the time span of the folders around holds too, the narrower of both
/// Depths   as `stated_depth` reads them; by default from the surface down to the sea bed
/// Edges    an empty attribute is as none; attributes that mean the same must agree
/// Faults   what is understood and cannot be read; a date that begins or ends something unknown
/// Unheeded a type that is no rule where none is stated, and words of the other rule than `kind_of_others`, also of the
///          folders around; dates and depths of something unknown
[[nodiscard]] ZoneAttributes read_zone_attributes(const OGRFeature& feature, AttributeMeanings& meanings,
                                                  std::optional<ocean::ZoneKind> kind_of_others);

/// Whether the feature states the rule of a zone.
[[nodiscard]] bool states_zone_kind(const OGRFeature& feature);

}  // namespace floeplan::ingest

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

/// Meanings of the names of a file's attributes. Each name is interpreted once and remembered.
class AttributeMeanings {
 public:
  [[nodiscard]] ocean::AttributeMeaning of(const std::string& name);

 private:
  std::map<std::string, ocean::AttributeMeaning> known_;
};

/// An attribute that seems to say something about a zone but is not applied.
struct Unheeded {
  std::string attribute;
  messages::Message told;
};

/// What the attributes of a feature say about a zone, and all their faults.
struct ZoneAttributes {
  ocean::Zone zone;  // without its area
  Messages faults;
  std::vector<Unheeded> unheeded;
};

/// Reads the attributes by the words of their names, as `ocean::meaning_of_attribute` understands them.
/// Rule     no_go (no-go, keep_out, exclusion) or stay_in (keep_in, inclusion), in any attribute except the
///          zone's name. The file's rule has priority over `kind_of_others`, which is for features without a
///          rule
/// Times    read by `stated_period` and `stated_interval`: a day, a month or a year is the whole of it;
///          "permanent" and the like have no end. In a KML file the time span of the folders around applies
///          too; the common part counts
/// Depths   read by `stated_depth`; without any, from the surface to the sea bed
/// Edges    an empty attribute counts as absent; attributes with the same meaning must agree
/// Faults   an attribute that is understood but cannot be read; a begin or end of something unknown
/// Unheeded a type that is no rule if none is stated; words of the rule opposite to `kind_of_others`, also in
/// the names of
///          folders; dates and depths of something unknown
[[nodiscard]] ZoneAttributes read_zone_attributes(const OGRFeature& feature, AttributeMeanings& meanings,
                                                  std::optional<ocean::ZoneKind> kind_of_others);

/// Whether the feature states the rule of a zone.
[[nodiscard]] bool states_zone_kind(const OGRFeature& feature);

}  // namespace floeplan::ingest

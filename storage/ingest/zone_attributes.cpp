#include "storage/ingest/zone_attributes.hpp"

#include <cpl_string.h>
#include <ogr_feature.h>

#include <algorithm>
#include <span>
#include <string_view>

#include "engine/core/letter_case.hpp"
#include "engine/core/utc_text.hpp"
#include "engine/ocean/zone_words.hpp"
#include "storage/ingest/feature_texts.hpp"
#include "storage/ingest/kml_file.hpp"
#include "storage/ingest/stated_period.hpp"
#include "storage/ingest/text.hpp"

namespace floeplan::ingest {
namespace {

using ocean::ZoneMember;
using Names = std::span<const std::string_view>;

constexpr double deepest_m = 11'000.0;
constexpr std::size_t longest_name = 200;  // bytes

/// One of a feature's attributes that has a value.
struct Attribute {
  std::string name;  // as the file writes it
  std::string text;
};

/// Reads attributes and notes what is wrong with them.
class AttributeReader {
 public:
  explicit AttributeReader(const OGRFeature& feature) : feature_{feature} {}

  [[nodiscard]] std::vector<std::string>& faults() { return faults_; }

  [[nodiscard]] std::optional<Attribute> find(Names names) {
    std::optional<Attribute> found;
    for (const std::string_view name : names) {
      for (int i = 0; i < feature_.GetFieldCount(); ++i) {
        const char* const own_name = feature_.GetFieldDefnRef(i)->GetNameRef();
        if (core::plain_word(own_name) != name) continue;
        Attribute attribute{table_text(own_name), text_of_field(feature_, i)};
        if (attribute.text.empty()) continue;
        if (found && found->text != attribute.text) {
          faults_.push_back("\"" + found->name + "\" and \"" + attribute.name +
                            "\" mean the same but differ; leave one of them out");
          return found;
        }
        if (!found) found = std::move(attribute);
      }
    }
    return found;
  }

  [[nodiscard]] std::optional<core::Metres> depth(Names names) {
    const auto attribute = find(names);
    if (!attribute) return std::nullopt;
    const auto metres = parse_number(attribute->text);
    if (metres && *metres >= 0.0 && *metres <= deepest_m) return core::Metres{*metres};
    faults_.push_back("\"" + attribute->name + "\" is \"" + attribute->text +
                      "\"; give metres below the surface, from 0 to 11000");
    return std::nullopt;
  }

  /// What the attribute spans; of what begins and ends another end is meant.
  [[nodiscard]] std::optional<StatedPeriod> period(const std::optional<Attribute>& attribute) {
    if (!attribute) return std::nullopt;
    const auto period = stated_period(attribute->text);
    if (!period)
      faults_.push_back("\"" + attribute->name + "\" is \"" + attribute->text +
                        "\"; give a date, or a time with its zone, as 2026-11-20T06:00:00Z");
    return period;
  }

  /// The rule's first moment: the later one of its own and of the folder's around it.
  [[nodiscard]] std::optional<core::UtcTime> first_moment() {
    const auto own = period(find(names_of(ZoneMember::from)));
    const auto around = period(find_field(folder_begin));
    if (own && around) return std::max(own->first, around->first);
    return own ? std::optional{own->first} : around ? std::optional{around->first} : std::nullopt;
  }

  /// Its last moment, of a day, month or year the last of them: the earlier one of its own and of the folder's.
  [[nodiscard]] std::optional<core::UtcTime> last_moment() {
    const auto own = period(find(names_of(ZoneMember::until)));
    const auto around = period(find_field(folder_end));
    if (own && around) return std::min(own->last, around->last);
    return own ? std::optional{own->last} : around ? std::optional{around->last} : std::nullopt;
  }

 private:
  [[nodiscard]] std::optional<Attribute> find_field(const char* name) const {
    const int index = feature_.GetFieldIndex(name);
    if (index < 0 || feature_.IsFieldSetAndNotNull(index) == 0) return std::nullopt;
    return Attribute{name, text_of_field(feature_, index)};
  }

  const OGRFeature& feature_;
  std::vector<std::string> faults_;
};

}  // namespace

std::optional<ocean::ZoneKind> zone_kind_of(const std::string& text) {
  const std::string word = core::plain_word(text);
  for (const std::string_view keep_out : {"nogo", "keepout", "exclusion"})
    if (word == keep_out) return ocean::ZoneKind::no_go;
  for (const std::string_view keep_in : {"stayin", "keepin", "inclusion"})
    if (word == keep_in) return ocean::ZoneKind::stay_in;
  return std::nullopt;
}

bool states_zone_kind(const OGRFeature& feature) {
  const auto kind = AttributeReader{feature}.find(names_of(ZoneMember::kind));
  return kind && zone_kind_of(kind->text);
}

ZoneAttributes read_zone_attributes(const OGRFeature& feature,
                                    std::optional<ocean::ZoneKind> kind_of_others) {
  AttributeReader reader{feature};
  ocean::Zone zone;
  if (const auto name = reader.find(names_of(ZoneMember::name)))
    zone.name = name->text.substr(0, longest_name);
  while (CPLIsUTF8(zone.name.c_str(), -1) == 0) zone.name.pop_back();  // cut inside a character

  if (const auto kind = reader.find(names_of(ZoneMember::kind))) {
    const auto known = zone_kind_of(kind->text);
    zone.kind = known.value_or(ocean::ZoneKind::no_go);
    if (!known)
      reader.faults().push_back("\"" + kind->name + "\" is \"" + kind->text +
                                "\"; write no_go (keep out) or stay_in (keep inside)");
  } else if (kind_of_others) {
    zone.kind = *kind_of_others;
  } else {
    reader.faults().push_back(
        "states no kind; add an attribute \"kind\" with no_go (keep out) or stay_in (keep inside), or give "
        "--zone-kind for all that state none");
  }
  zone.from = reader.first_moment();
  zone.until = reader.last_moment();
  if (const auto top = reader.depth(names_of(ZoneMember::top))) zone.top = *top;
  if (const auto bottom = reader.depth(names_of(ZoneMember::bottom))) zone.bottom = *bottom;
  if (zone.from && zone.until && *zone.until < *zone.from)
    reader.faults().push_back("ends at " + core::iso8601(*zone.until) + ", before it begins at " +
                              core::iso8601(*zone.from) + "; correct one of them");
  if (zone.from && zone.until && *zone.until == *zone.from)
    reader.faults().push_back("is in force at " + core::iso8601(*zone.from) +
                              " alone, a moment that no plan would meet; give its first and its last moment");
  if (zone.bottom < zone.top)
    reader.faults().push_back("ends above " + number(zone.top.value) +
                              " m, where it begins; depths count downwards");
  return {std::move(zone), std::move(reader.faults())};
}

}  // namespace floeplan::ingest

#include "storage/ingest/zone_attributes.hpp"

#include <cpl_conv.h>
#include <cpl_string.h>
#include <ogr_feature.h>

#include <algorithm>
#include <memory>
#include <span>
#include <string_view>

#include "engine/core/letter_case.hpp"
#include "engine/core/utc_text.hpp"
#include "engine/ocean/zone_words.hpp"
#include "storage/ingest/feature_texts.hpp"
#include "storage/ingest/text.hpp"

namespace floeplan::ingest {
namespace {

using ocean::ZoneMember;
using Names = std::span<const std::string_view>;

constexpr double deepest_m = 11'000.0;
constexpr core::Seconds whole_day{86'400.0};
constexpr std::size_t longest_name = 200;  // bytes

/// Tables without a stated encoding hold Latin-1 as a rule.
std::string as_utf8(const char* text) {
  if (CPLIsUTF8(text, -1) != 0) return trimmed(text);
  const std::unique_ptr<char, decltype(&VSIFree)> recoded{CPLRecode(text, CPL_ENC_ISO8859_1, CPL_ENC_UTF8),
                                                          &VSIFree};
  return trimmed(recoded.get());
}

/// One of a feature's attributes that has a value.
struct Attribute {
  int index;
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
        if (core::plain_word(own_name) != name || feature_.IsFieldSetAndNotNull(i) == 0) continue;
        Attribute attribute{i, as_utf8(own_name), as_utf8(feature_.GetFieldAsString(i))};
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

  /// `is_last`: of a date alone the end of the day is meant, not its beginning.
  [[nodiscard]] std::optional<core::UtcTime> time(Names names, bool is_last) {
    const auto attribute = find(names);
    if (!attribute) return std::nullopt;
    const std::string text = iso_text(*attribute);
    const auto time = core::parse_iso8601(text);
    const bool date_alone = text.size() == std::string_view{"2026-11-20"}.size();
    if (time) return date_alone && is_last ? *time + whole_day : *time;
    faults_.push_back("\"" + attribute->name + "\" is \"" + attribute->text +
                      "\"; give a date, or a time with its zone, as 2026-11-20T06:00:00Z");
    return std::nullopt;
  }

 private:
  /// A field of times as ISO 8601; other fields as they are written.
  [[nodiscard]] std::string iso_text(const Attribute& attribute) const {
    const OGRFieldType type = feature_.GetFieldDefnRef(attribute.index)->GetType();
    if (type != OFTDate && type != OFTDateTime) return attribute.text;
    int year = 0;
    int month = 0;
    int day = 0;
    int hour = 0;
    int minute = 0;
    float second = 0.0F;
    int zone = 0;  // 0: not stated, 1: local, 100: UTC, in quarters of an hour from there
    feature_.GetFieldAsDateTime(attribute.index, &year, &month, &day, &hour, &minute, &second, &zone);
    char text[64];
    if (type == OFTDate) {
      std::snprintf(text, sizeof text, "%04d-%02d-%02d", year, month, day);
      return text;
    }
    if (zone < 2) return attribute.text;
    const int offset_min = 15 * (zone - 100);
    std::snprintf(text, sizeof text, "%04d-%02d-%02dT%02d:%02d:%06.3f%c%02d:%02d", year, month, day, hour,
                  minute, static_cast<double>(second), offset_min < 0 ? '-' : '+', std::abs(offset_min) / 60,
                  std::abs(offset_min) % 60);
    return text;
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
  zone.from = reader.time(names_of(ZoneMember::from), false);
  zone.until = reader.time(names_of(ZoneMember::until), true);
  if (const auto top = reader.depth(names_of(ZoneMember::top))) zone.top = *top;
  if (const auto bottom = reader.depth(names_of(ZoneMember::bottom))) zone.bottom = *bottom;
  if (zone.from && zone.until && *zone.until < *zone.from)
    reader.faults().push_back("ends at " + core::iso8601(*zone.until) + ", before it begins at " +
                              core::iso8601(*zone.from) + "; correct one of them");
  if (zone.bottom < zone.top)
    reader.faults().push_back("ends above " + number(zone.top.value) +
                              " m, where it begins; depths count downwards");
  return {std::move(zone), std::move(reader.faults())};
}

}  // namespace floeplan::ingest

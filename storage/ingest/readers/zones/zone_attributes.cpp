#include "storage/ingest/readers/zones/zone_attributes.hpp"

#include <cpl_string.h>
#include <ogr_feature.h>

#include <algorithm>
#include <array>

#include "engine/core/letter_case.hpp"
#include "engine/core/utc_text.hpp"
#include "engine/messages/ingest_area_messages.hpp"
#include "storage/ingest/formats/vector/feature_texts.hpp"
#include "storage/ingest/formats/vector/vector_files.hpp"
#include "storage/ingest/notation/stated_depth.hpp"
#include "storage/ingest/notation/stated_period.hpp"
#include "storage/ingest/notation/stated_rule.hpp"
#include "storage/ingest/notation/table_text.hpp"
#include "storage/ingest/notation/text.hpp"

namespace floeplan::ingest {
namespace {

using ocean::AttributeMeaning;

constexpr std::size_t longest_name = 200;   // bytes
constexpr std::size_t longest_quote = 120;  // bytes, of free text

/// An attribute of a feature that has a value.
struct Attribute {
  std::string name;  // in the spelling of the file
  std::string text;
  AttributeMeaning meaning{};
};

std::string cut(std::string text, std::size_t most_bytes) {
  if (text.size() <= most_bytes) return text;
  text.resize(most_bytes);
  while (CPLIsUTF8(text.c_str(), -1) == 0) text.pop_back();  // the text was cut inside a character
  return text;
}

std::string said(const Attribute& attribute) {
  const bool is_whole = attribute.text.size() <= longest_quote;
  return "\"" + attribute.name + "\" is \"" + cut(attribute.text, longest_quote) +
         (is_whole ? "\"" : "...\"");
}

/// A period; an end without a value is open.
struct Period {
  std::optional<core::UtcTime> first;
  std::optional<core::UtcTime> last;

  [[nodiscard]] bool is_empty() const { return first && last && !(*first < *last); }
  [[nodiscard]] std::string words() const {
    if (!first) return "until " + core::iso8601(*last);
    return last ? core::iso8601(*first) + " to " + core::iso8601(*last) : "from " + core::iso8601(*first);
  }
};

Period common_part(const Period& one, const Period& other) {
  const auto later = [](const auto& a, const auto& b) { return a && b ? std::max(a, b) : a ? a : b; };
  const auto earlier = [](const auto& a, const auto& b) { return a && b ? std::min(a, b) : a ? a : b; };
  return {later(one.first, other.first), earlier(one.last, other.last)};
}

/// A value stated by one or several attributes, which agree.
template <class Value>
struct Stated {
  std::optional<Value> value;
  std::string by;  // name of the first of these attributes
};

/// Reads attributes and collects their faults.
class AttributeReader {
 public:
  AttributeReader(const OGRFeature& feature, AttributeMeanings& meanings) {
    for (int i = 0; i < feature.GetFieldCount(); ++i) {
      const std::string name = feature.GetFieldDefnRef(i)->GetNameRef();
      Attribute attribute{table_text(name.c_str()), text_of_field(feature, i)};
      if (attribute.text.empty()) continue;
      if (std::optional<Attribute>* const of_kml = kml_attribute(name)) {
        *of_kml = std::move(attribute);
        continue;
      }
      attribute.meaning = meanings.of(name);
      attributes_.push_back(std::move(attribute));
    }
  }

  [[nodiscard]] std::string name() {
    Stated<std::string> name;
    for (const Attribute& attribute : all(AttributeMeaning::zone_name))
      state(name, attribute, attribute.text);
    return cut(name.value.value_or(""), longest_name);
  }

  [[nodiscard]] ocean::ZoneKind kind(std::optional<ocean::ZoneKind> kind_of_others) {
    Stated<ocean::ZoneKind> stated;
    for (const Attribute& attribute : attributes_) {
      const auto rule = stated_rule(attribute.meaning, attribute.text);
      if (rule) {
        state(stated, attribute, *rule);
      } else if (attribute.meaning == AttributeMeaning::kind) {
        faults_.push_back(messages::ingest_area_message<"zone-kind-unreadable">(said(attribute)));
        stated.value = stated.value.value_or(ocean::ZoneKind::no_go);
      }
    }
    if (stated.value) return *stated.value;
    if (!kind_of_others) {
      faults_.push_back(messages::ingest_area_message<"zone-kind-missing">());
      return ocean::ZoneKind::no_go;
    }
    tell_of_the_other_rule(*kind_of_others);
    for (const Attribute& attribute : all(AttributeMeaning::perhaps_kind))
      leave_unheeded(attribute, messages::ingest_area_message<"zone-type-not-obeyed">(
                                    said(attribute), ocean::zone_kind_name(*kind_of_others)));
    return *kind_of_others;
  }

  /// The period of a zone: the common part of its own period and the folder's.
  [[nodiscard]] Period period() {
    const Period own = own_period();
    const Period around = folder_period();
    Period both = common_part(own, around);
    if (own.is_empty()) {
      tell_empty(own);
    } else if (around.is_empty()) {
      tell_empty(around);
    } else if (both.is_empty()) {
      faults_.push_back(messages::ingest_area_message<"periods-do-not-overlap">(own.words(), around.words()));
    }
    return both;
  }

  void read_depths(ocean::Zone& zone) {
    Stated<core::Metres> top;
    Stated<core::Metres> bottom;
    for (const Attribute& attribute : attributes_) {
      const bool is_top = attribute.meaning == AttributeMeaning::top;
      if (is_top || attribute.meaning == AttributeMeaning::bottom) {
        const auto depth = stated_depth(attribute.text, ocean::unit_in_attribute(attribute.name));
        if (depth)
          state(is_top ? top : bottom, attribute, *depth);
        else
          faults_.push_back(messages::ingest_area_message<"zone-depth-unreadable">(said(attribute)));
      } else if (attribute.meaning == AttributeMeaning::depths ||
                 attribute.meaning == AttributeMeaning::unclear_depth) {
        read_range(attribute, top, bottom);
      }
    }
    if (top.value) zone.top = *top.value;
    if (bottom.value) zone.bottom = *bottom.value;
    if (zone.bottom < zone.top)
      faults_.push_back(messages::ingest_area_message<"zone-ends-above-its-top">(number(zone.top.value)));
  }

  [[nodiscard]] Messages& faults() { return faults_; }
  [[nodiscard]] std::vector<Unheeded>& unheeded() { return unheeded_; }

 private:
  /// Where to store an attribute that the KML reader added; null for the zone's own attributes.
  [[nodiscard]] std::optional<Attribute>* kml_attribute(std::string_view name) {
    if (name == folder_begin) return &folder_begins_;
    if (name == folder_end) return &folder_ends_;
    if (name == folder_names) return &folder_names_;
    return name == time_stamp ? &time_stamp_ : nullptr;
  }

  /// Warns of names and descriptions whose words state another rule than --zone-kind.
  void tell_of_the_other_rule(ocean::ZoneKind rule) {
    const ocean::ZoneKind other =
        rule == ocean::ZoneKind::no_go ? ocean::ZoneKind::stay_in : ocean::ZoneKind::no_go;
    const auto tell = [&](const Attribute& attribute) {
      if (!has_words_of(attribute.text, other)) return;
      leave_unheeded(attribute,
                     messages::ingest_area_message<"zone-words-not-obeyed">(
                         said(attribute), ocean::zone_kind_name(other), ocean::zone_kind_name(rule)));
    };
    for (const Attribute& attribute : attributes_)
      if (attribute.meaning != AttributeMeaning::perhaps_kind) tell(attribute);
    if (folder_names_) tell(*folder_names_);
  }

  [[nodiscard]] std::vector<Attribute> all(AttributeMeaning meaning) const {
    std::vector<Attribute> found;
    std::ranges::copy_if(attributes_, std::back_inserter(found),
                         [&](const Attribute& attribute) { return attribute.meaning == meaning; });
    return found;
  }

  template <class Value>
  void state(Stated<Value>& stated, const Attribute& attribute, const Value& value) {
    if (stated.value && *stated.value != value)
      faults_.push_back(messages::ingest_area_message<"attributes-differ">(stated.by, attribute.name));
    if (!stated.value) stated = {value, attribute.name};
  }

  void leave_unheeded(const Attribute& attribute, messages::Message told) {
    unheeded_.push_back({attribute.name, std::move(told)});
  }

  void refuse_time(const Attribute& attribute) {
    faults_.push_back(messages::ingest_area_message<"zone-time-unreadable">(said(attribute)));
  }

  void tell_empty(const Period& period) {
    if (*period.first == *period.last)
      faults_.push_back(messages::ingest_area_message<"zone-of-one-moment">(*period.first));
    else
      faults_.push_back(
          messages::ingest_area_message<"zone-ends-before-it-begins">(*period.last, *period.first));
  }

  [[nodiscard]] Period folder_period() {
    const auto read = [&](const std::optional<Attribute>& attribute) {
      const auto period = attribute ? stated_period(attribute->text) : std::nullopt;
      if (attribute && !period) refuse_time(*attribute);
      return period;
    };
    const auto begin = read(folder_begins_);
    const auto end = read(folder_ends_);
    return {begin ? std::optional{begin->first} : std::nullopt,
            end ? std::optional{end->last} : std::nullopt};
  }

  [[nodiscard]] Period own_period() {
    Stated<core::UtcTime> first;
    Stated<core::UtcTime> last;
    std::vector<Attribute> dates;
    std::vector<Attribute> texts;
    if (time_stamp_) {
      const auto period = stated_period(time_stamp_->text);
      if (!period) refuse_time(*time_stamp_);
      if (period) state(first, *time_stamp_, period->first);
      if (period) state(last, *time_stamp_, period->last);
    }
    for (const Attribute& attribute : attributes_) {
      switch (attribute.meaning) {
        using enum AttributeMeaning;
        case from:
        case until: read_moment(attribute, attribute.meaning == from ? first : last); break;
        case period: read_interval(attribute, first, last); break;
        case unclear_period:
          if (could_be_date(attribute.text))
            faults_.push_back(messages::ingest_area_message<"zone-date-unclear">(said(attribute)));
          break;
        case some_date:
        case nothing:
          if (could_be_date(attribute.text))
            dates.push_back(attribute);
          else if (mentions_date(attribute.text))
            texts.push_back(attribute);
          break;
        default: break;
      }
    }
    for (const Attribute& date : dates) {
      // No message for a date that repeats another attribute, as KML's timestamp does, nor for a number that
      // looks like a date.
      const bool is_number = parse_number(date.text).has_value();
      if (date.meaning == AttributeMeaning::some_date ? !first.value && !last.value : !is_number)
        leave_unheeded(date, messages::ingest_area_message<"zone-date-not-obeyed">(said(date)));
    }
    for (const Attribute& text : texts)
      if (!first.value && !last.value)
        leave_unheeded(text, messages::ingest_area_message<"zone-text-not-obeyed">(said(text)));
    return {first.value, last.value};
  }

  void read_moment(const Attribute& attribute, Stated<core::UtcTime>& stated) {
    if (is_without_end(attribute.text)) return;
    const auto period = stated_period(attribute.text);
    if (!period) return refuse_time(attribute);
    state(stated, attribute, attribute.meaning == AttributeMeaning::from ? period->first : period->last);
  }

  void read_interval(const Attribute& attribute, Stated<core::UtcTime>& first, Stated<core::UtcTime>& last) {
    if (is_without_end(attribute.text) || is_yes(attribute.text)) return;
    const auto interval = stated_interval(attribute.text);
    if (!interval) {
      faults_.push_back(messages::ingest_area_message<"zone-period-unreadable">(said(attribute)));
      return;
    }
    if (interval->first) state(first, attribute, *interval->first);
    if (interval->last) state(last, attribute, *interval->last);
  }

  void read_range(const Attribute& attribute, Stated<core::Metres>& top, Stated<core::Metres>& bottom) {
    const bool is_clear = attribute.meaning == AttributeMeaning::depths;
    const auto range = stated_depths(attribute.text, ocean::unit_in_attribute(attribute.name));
    if (is_clear && range) {
      state(top, attribute, range->top);
      state(bottom, attribute, range->bottom);
    } else if (attribute.text.find_first_of("0123456789") != std::string::npos) {
      leave_unheeded(attribute, messages::ingest_area_message<"zone-depth-not-obeyed">(said(attribute)));
    }
  }

  std::vector<Attribute> attributes_;
  std::optional<Attribute> folder_names_;
  std::optional<Attribute> time_stamp_;
  std::optional<Attribute> folder_begins_;
  std::optional<Attribute> folder_ends_;
  Messages faults_;
  std::vector<Unheeded> unheeded_;
};

}  // namespace

AttributeMeaning AttributeMeanings::of(const std::string& name) {
  const auto [known, is_new] = known_.try_emplace(name, AttributeMeaning::nothing);
  if (is_new) known->second = ocean::meaning_of_attribute(name);
  return known->second;
}

bool states_zone_kind(const OGRFeature& feature) {
  for (int i = 0; i < feature.GetFieldCount(); ++i) {
    Attribute attribute{feature.GetFieldDefnRef(i)->GetNameRef(), text_of_field(feature, i)};
    if (attribute.name == folder_names || !zone_kind_of(attribute.text)) continue;
    attribute.meaning = ocean::meaning_of_attribute(attribute.name);
    if (stated_rule(attribute.meaning, attribute.text)) return true;
  }
  return false;
}

ZoneAttributes read_zone_attributes(const OGRFeature& feature, AttributeMeanings& meanings,
                                    std::optional<ocean::ZoneKind> kind_of_others) {
  AttributeReader reader{feature, meanings};
  ocean::Zone zone;
  zone.name = reader.name();
  zone.kind = reader.kind(kind_of_others);
  const Period period = reader.period();
  zone.from = period.first;
  zone.until = period.last;
  reader.read_depths(zone);
  return {std::move(zone), std::move(reader.faults()), std::move(reader.unheeded())};
}

}  // namespace floeplan::ingest

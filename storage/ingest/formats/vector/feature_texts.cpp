#include "storage/ingest/formats/vector/feature_texts.hpp"

#include <ogr_feature.h>

#include <array>
#include <cstdio>
#include <cstdlib>

#include "engine/core/letter_case.hpp"
#include "storage/ingest/notation/table_text.hpp"

namespace floeplan::ingest {
namespace {

/// ISO 8601 text of a date or time attribute.
std::string iso_of_field(const OGRFeature& feature, int index) {
  int year = 0;
  int month = 0;
  int day = 0;
  int hour = 0;
  int minute = 0;
  float second = 0.0F;
  int zone =
      // GDAL's zone flag. 0: unknown, 1: unspecified local time, 100: UTC, plus 1 for every quarter of an
      // hour east
      0;
  feature.GetFieldAsDateTime(index, &year, &month, &day, &hour, &minute, &second, &zone);
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%04d-%02d-%02d", year, month, day);
  std::string iso = text.data();
  if (feature.GetFieldDefnRef(index)->GetType() == OFTDate) return iso;
  const bool is_whole = second == static_cast<float>(static_cast<int>(second));
  std::snprintf(text.data(), text.size(), is_whole ? "T%02d:%02d:%02.0f" : "T%02d:%02d:%06.3f", hour, minute,
                static_cast<double>(second));
  iso += text.data();
  if (zone < 2) return iso;
  if (zone == 100) return iso + "Z";
  const int offset_min = 15 * (zone - 100);
  std::snprintf(text.data(), text.size(), "%c%02d:%02d", offset_min < 0 ? '-' : '+',
                std::abs(offset_min) / 60, std::abs(offset_min) % 60);
  return iso + text.data();
}

}  // namespace

std::string text_of_field(const OGRFeature& feature, int index) {
  if (feature.IsFieldSetAndNotNull(index) == 0) return {};
  const OGRFieldType type = feature.GetFieldDefnRef(index)->GetType();
  if (type == OFTDate || type == OFTDateTime) return iso_of_field(feature, index);
  if (feature.GetFieldDefnRef(index)->GetSubType() == OFSTBoolean)
    return feature.GetFieldAsInteger(index) != 0 ? "true" : "false";
  return table_text(feature.GetFieldAsString(index));
}

std::optional<std::string> text_of_feature(const OGRFeature& feature,
                                           std::span<const std::string_view> names) {
  for (const std::string_view name : names) {
    for (int i = 0; i < feature.GetFieldCount(); ++i) {
      if (core::plain_word(feature.GetFieldDefnRef(i)->GetNameRef()) != name) continue;
      if (std::string text = text_of_field(feature, i); !text.empty()) return text;
    }
  }
  return std::nullopt;
}

}  // namespace floeplan::ingest

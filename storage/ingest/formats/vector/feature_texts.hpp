#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

class OGRFeature;

namespace floeplan::ingest {

/// The value of an attribute as text: numbers and texts as in the file, dates and times in ISO 8601 instead
/// of GDAL's own notation. A time without a zone keeps none. Empty if the attribute has no value.
[[nodiscard]] std::string text_of_field(const OGRFeature& feature, int index);

/// The value of the first attribute with one of these names (in the form of `core::plain_word`) that has a
/// value.
[[nodiscard]] std::optional<std::string> text_of_feature(const OGRFeature& feature,
                                                         std::span<const std::string_view> names);

}  // namespace floeplan::ingest

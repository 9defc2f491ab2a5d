#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

class OGRFeature;

namespace floeplan::ingest {

/// The value of an attribute: numbers and texts as the file writes them, dates and times in ISO 8601 and not as GDAL
/// spells them, which no file holds; a time without a zone stays without one. Empty where it has none.
[[nodiscard]] std::string text_of_field(const OGRFeature& feature, int index);

/// The first attribute with one of these names (as `core::plain_word` has them) that has a value.
[[nodiscard]] std::optional<std::string> text_of_feature(const OGRFeature& feature,
                                                         std::span<const std::string_view> names);

}  // namespace floeplan::ingest

#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

class OGRFeature;

namespace floeplan::ingest {

/// The first attribute with one of these names (as `core::plain_word` has them) that has a value, as UTF-8; tables
/// without a stated encoding hold Latin-1 as a rule.
[[nodiscard]] std::optional<std::string> text_of_feature(const OGRFeature& feature,
                                                         std::span<const std::string_view> names);

}  // namespace floeplan::ingest

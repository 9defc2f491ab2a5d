#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

class OGRFeature;

namespace floeplan::ingest {

/// Letters and digits alone, in lower case: how names and words of different makers are compared.
[[nodiscard]] std::string plain_word(std::string_view text);

/// The first attribute with one of these plain names that has a value, as UTF-8; tables without a stated encoding hold
/// Latin-1 as a rule.
[[nodiscard]] std::optional<std::string> text_of_feature(const OGRFeature& feature,
                                                         std::span<const std::string_view> names);

}  // namespace floeplan::ingest

#pragma once

#include <optional>
#include <string_view>

#include "engine/ocean/zone.hpp"
#include "engine/ocean/zone_words.hpp"

namespace floeplan::ingest {

/// The kind of zone in a text: "no-go", "keep out" and the like, in any accepted spelling.
[[nodiscard]] std::optional<ocean::ZoneKind> zone_kind_of(std::string_view text);

/// The zone rule that an attribute's value `text` states; empty if none. An ambiguous word ("exclusion")
/// counts only if the attribute's name, by `meaning`, announces the kind of a zone.
[[nodiscard]] std::optional<ocean::ZoneKind> stated_rule(ocean::AttributeMeaning meaning,
                                                         std::string_view text);

/// Whether a text stands for an unlimited period: "permanent", "always" and the like.
[[nodiscard]] bool is_without_end(std::string_view text);

/// Whether a text says yes: "yes", "true" and the like. An attribute such as "valid: true" states no period.
[[nodiscard]] bool is_yes(std::string_view text);

/// Whether an attribute, by its name and value, states the rule, times or depths of a zone.
[[nodiscard]] bool says_what_a_zone_is(std::string_view name, std::string_view text);

/// Whether free text, as a zone's name or description, contains words of a rule: "must stay inside" for
/// stay_in, "no entry" for no_go. Such words set no rule; they serve to warn if the zone's rule is the
/// opposite one.
[[nodiscard]] bool has_words_of(std::string_view text, ocean::ZoneKind rule);

}  // namespace floeplan::ingest

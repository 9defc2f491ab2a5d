#pragma once

#include <optional>
#include <string_view>

#include "engine/ocean/zone.hpp"
#include "engine/ocean/zone_words.hpp"

namespace floeplan::ingest {

/// "no-go", "keep out" and the like, in any spelling that is accepted.
[[nodiscard]] std::optional<ocean::ZoneKind> zone_kind_of(std::string_view text);

/// The rule in an attribute whose name means `meaning`; empty: it states none. Words that have another meaning, too
/// ("exclusion"), count only where the name says that a kind follows.
[[nodiscard]] std::optional<ocean::ZoneKind> stated_rule(ocean::AttributeMeaning meaning,
                                                         std::string_view text);

/// "permanent", "always" and the like, in place of a date.
[[nodiscard]] bool is_without_end(std::string_view text);

/// "yes", "true" and the like: "valid: true" states no period.
[[nodiscard]] bool is_yes(std::string_view text);

/// Whether an attribute, by its name and what it holds, says what a zone is: its rule, times or depths.
[[nodiscard]] bool says_what_a_zone_is(std::string_view name, std::string_view text);

/// Whether free text, as the name or the description of a zone, has words of a rule: "must stay inside" of stay_in, "no
/// entry" of no_go. Nothing to obey, but to tell where the rule of the zone is the other one.
[[nodiscard]] bool has_words_of(std::string_view text, ocean::ZoneKind rule);

}  // namespace floeplan::ingest

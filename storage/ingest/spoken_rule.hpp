#pragma once

#include <string_view>

#include "engine/ocean/zone.hpp"

namespace floeplan::ingest {

/// Whether free text, as the name or the description of a zone, has words of a rule: "must stay inside" of stay_in, "no
/// entry" of no_go. Nothing to obey, but to tell where the rule of the zone is the other one.
[[nodiscard]] bool has_words_of(std::string_view text, ocean::ZoneKind rule);

}  // namespace floeplan::ingest

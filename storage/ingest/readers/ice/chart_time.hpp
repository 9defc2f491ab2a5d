#pragma once

#include <optional>
#include <string>

#include "engine/core/units.hpp"

namespace floeplan::ingest {

/// The moment that a file's name states, as ice services name their charts: "..._20261120T1800Z_...",
/// "202611201800_...", "..._20261120_..."; of a day alone its noon. Nothing where no digits are a date after 1950, or
/// several dates differ.
[[nodiscard]] std::optional<core::UtcTime> time_in_name(const std::string& name);

}  // namespace floeplan::ingest

#pragma once

#include <optional>
#include <string>

#include "engine/core/units.hpp"

namespace floeplan::ingest {

/// The time in the name of an ice chart file: "..._20261120T1800Z_...", "202611201800_...",
/// "..._20261120_..."; a day without a time counts as its noon, UTC. nullopt if no digits are a date from
/// 1950 on, or if several dates differ.
[[nodiscard]] std::optional<core::UtcTime> time_in_name(const std::string& name);

}  // namespace floeplan::ingest

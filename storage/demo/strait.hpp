#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "engine/core/units.hpp"

namespace floeplan::demo {

/// Writes an invented strait between two invented shores, in the open water of Davis Strait: depths, coastline and
/// hourly currents for six days. In the narrows, 5 km wide, the tide runs at up to one and a half times the speed of
/// a glider; outside it is weak, so that a vehicle can wait there. The tide is counted from `start`: the same hours
/// after it find the same tide.
/// Returns  the files written, in the order in which they are best ingested
[[nodiscard]] std::vector<std::filesystem::path> write_strait(const std::filesystem::path& dir,
                                                              std::uint64_t seed, core::UtcTime start);

}  // namespace floeplan::demo

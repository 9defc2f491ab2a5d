#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "engine/core/units.hpp"

namespace floeplan::demo {

/// Writes invented pack ice in the middle of Baffin Bay, with the depths and the hourly currents below it, for six
/// days: a belt of closed ice 80 km wide between open water in the east and in the west, with three leads in it that
/// lie beside the straight line across. The ice drifts slowly southwards and takes its leads along.
/// Returns  the files written, in the order in which they are best ingested
[[nodiscard]] std::vector<std::filesystem::path> write_pack_ice(const std::filesystem::path& dir,
                                                                std::uint64_t seed, core::UtcTime start);

}  // namespace floeplan::demo

#pragma once

#include <filesystem>
#include <vector>

#include "engine/core/units.hpp"

namespace floeplan::demo {

/// Writes the river of the reference paper, equation (1), enlarged to a strait 30 km wide, and a flat sea
/// bed.
/// Returns  the files written
/// Source   Eichhorn 2009, section IV
[[nodiscard]] std::vector<std::filesystem::path> write_river(const std::filesystem::path& dir,
                                                             core::UtcTime start);

/// Writes the meandering jet of the reference paper, equations (2) to (4), enlarged to 110 km, and a flat sea
/// bed.
[[nodiscard]] std::vector<std::filesystem::path> write_jet(const std::filesystem::path& dir,
                                                           core::UtcTime start);

}  // namespace floeplan::demo

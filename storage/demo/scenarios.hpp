#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "engine/core/units.hpp"

namespace floeplan::demo {

/// Writes an invented strait between two invented shores, in the open water of Davis Strait: depths,
/// coastline and hourly currents for six days. In the narrows, 5 km wide, the tide runs at up to one and a
/// half times the speed of a glider; outside of them it is weak, so that a vehicle can hold there. The phase
/// of the tide counts from `start`: data for two starts have the same tide the same time after their start.
/// Returns  the files written, in the order in which they are best ingested
[[nodiscard]] std::vector<std::filesystem::path> write_strait(const std::filesystem::path& dir,
                                                              std::uint64_t seed, core::UtcTime start);

/// Writes invented pack ice in the middle of Baffin Bay for six days, with the depths and the hourly currents
/// below it: a belt of closed ice 80 km wide, with open water to the east and to the west, and an island far from
/// the straight line across. The ice drifts slowly southwards, and its three leads with it. Two lie on the line, the
/// third is north of two icebergs that lie on the line between them. So the shortest route passes south of the
/// icebergs, where the ice is closed for a day, and the route with the fewest hours below ice passes north of them.
/// Returns  the files written, in the order in which they are best ingested
[[nodiscard]] std::vector<std::filesystem::path> write_pack_ice(const std::filesystem::path& dir,
                                                                std::uint64_t seed, core::UtcTime start);

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

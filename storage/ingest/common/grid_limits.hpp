#pragma once

#include <cstdint>

namespace floeplan::ingest {

/// The largest number of points of one grid. From a larger grid the pilot has to cut out an area.
inline constexpr std::uint64_t max_grid_points = 10'000'000;
/// The largest number of values of one variable, over all times and levels.
inline constexpr std::uint64_t max_grid_values = 4'000'000'000;

}  // namespace floeplan::ingest

#pragma once

#include <cstdint>

namespace floeplan::ingest {

/// What this program accepts of one grid; larger ones are for the pilot to cut out the area of.
inline constexpr std::uint64_t max_grid_points = 10'000'000;
/// The most values of one variable, all times and levels together.
inline constexpr std::uint64_t max_grid_values = 4'000'000'000;

}  // namespace floeplan::ingest

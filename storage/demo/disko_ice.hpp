#pragma once

#include <cstdint>

#include "engine/core/units.hpp"
#include "storage/demo/disko_bathymetry.hpp"
#include "storage/demo/ice_file.hpp"

namespace floeplan::demo {

/// Invented drift ice in the south of Disko Bay: a closed field of first-year ice with a patch of open water in its
/// middle, drifting slowly westwards, and open water around it. A vehicle that crosses it can surface in that patch
/// only.
[[nodiscard]] IceLayer make_disko_ice(const Relief& relief, const RasterFrame& frame, std::uint64_t seed,
                                      core::Seconds since_start);

}  // namespace floeplan::demo

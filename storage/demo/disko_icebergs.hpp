#pragma once

#include <cstdint>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/ocean/ice/iceberg.hpp"
#include "storage/demo/disko_bathymetry.hpp"

namespace floeplan::demo {

/// Sixty invented icebergs: most in the icefjord, on its sill and in the outflow, the others scattered over
/// the bay. Lengths are log-normal between 20 and 600 m; drafts follow from the length and end at the sea
/// bed. Seen up to 20 h before `start`. Apart from one small berg, the corridor between 53.20W and 51.60W on
/// 69.20N is clear by 7 km on both sides.
/// Source   draft: Barker et al. 2004 up to 160 m length, Hotzel and Miller 1983 above
[[nodiscard]] std::vector<ocean::Iceberg> make_disko_icebergs(const Relief& relief, std::uint64_t seed,
                                                              core::UtcTime start);

}  // namespace floeplan::demo

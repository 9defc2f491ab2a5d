#pragma once

#include <string>

#include "engine/geo/lon_lat.hpp"

namespace floeplan::ingest {

/// Why a position that a file states is no place on the Earth; empty when it is one.
[[nodiscard]] std::string fault_of_place(geo::LonLat place);

}  // namespace floeplan::ingest

#pragma once

#include <optional>

#include "engine/geo/lon_lat.hpp"
#include "engine/messages/message.hpp"

namespace floeplan::ingest {

/// Why a position in a file is not a place on the Earth; empty if it is one.
[[nodiscard]] std::optional<messages::Message> fault_of_place(geo::LonLat place);

}  // namespace floeplan::ingest

#pragma once

#include <optional>

#include "engine/geo/lon_lat.hpp"
#include "engine/messages/message.hpp"

namespace floeplan::ingest {

/// Why a position that a file states is no place on the Earth; empty when it is one.
[[nodiscard]] std::optional<messages::Message> fault_of_place(geo::LonLat place);

}  // namespace floeplan::ingest

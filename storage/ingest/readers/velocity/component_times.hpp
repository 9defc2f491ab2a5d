#pragma once

#include <optional>
#include <string>

#include "engine/messages/message.hpp"
#include "storage/ingest/formats/netcdf/netcdf_layout.hpp"

namespace floeplan::ingest {

/// Why two components cannot be read together: no time, other times or other depths; nullopt when they can.
[[nodiscard]] std::optional<messages::Message> times_or_depths_differ(const NetcdfLayout& first,
                                                                      const NetcdfLayout& second);

}  // namespace floeplan::ingest

#pragma once

#include <optional>
#include <string>

#include "engine/messages/message.hpp"
#include "storage/ingest/formats/netcdf/netcdf_layout.hpp"
#include "storage/ingest/readers/velocity/velocity_pair.hpp"

namespace floeplan::ingest {

/// Why axes of longitude and latitude may be wrong for components along a model's grid: in high northern
/// latitudes the grids of global models are curved around two poles on land, but their files also contain
/// "nominal" axes. nullopt if there is no doubt.
/// Source  Murray 1996, Explicit generation of orthogonal grids for ocean models, J. Comp. Phys. 126 (tripolar grids);
///         they begin at 65 degrees in MOM, OM2 and CM2
[[nodiscard]] std::optional<messages::Message> doubt_in_nominal_axes(const VelocityPair& pair,
                                                                     double northernmost_deg);

/// Why two components cannot be read together (no time, different times or depths); nullopt if they can.
[[nodiscard]] std::optional<messages::Message> times_or_depths_differ(const NetcdfLayout& first,
                                                                      const NetcdfLayout& second);

}  // namespace floeplan::ingest

#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <utility>

#include "engine/core/units.hpp"
#include "engine/geo/bounding_box.hpp"

namespace floeplan::routes {

/// The spatial extent of a collection as OGC API documents state it, in CRS84: the box round all of its parts first,
/// which runs across the antimeridian (west beyond east) where that is shorter, then that of each part, where there
/// are several but not many. Rounded away from the data, so that a client that prints fewer digits still asks for all
/// of them.
/// `boxes`  one or more
[[nodiscard]] nlohmann::json spatial_extent(std::span<const geo::BoundingBox> boxes);

/// Both ends included; an end is open where it is empty.
struct ExtentPeriod {
  std::optional<core::UtcTime> from;
  std::optional<core::UtcTime> to;
};

/// The temporal extent: the period of all parts first, then those that do not touch, where there are several but not
/// many.
/// `periods`  one or more
[[nodiscard]] nlohmann::json temporal_extent(std::span<const ExtentPeriod> periods);

}  // namespace floeplan::routes

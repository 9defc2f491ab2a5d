#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <utility>

#include "engine/core/units.hpp"
#include "engine/geo/bounding_box.hpp"

namespace floeplan::routes {

/// The spatial extent of a collection in OGC API documents, in CRS84: first the box around all parts, which
/// crosses the antimeridian (west greater than east) if that is smaller; then the boxes of the parts, if
/// there are several but not many. Rounded outwards, so that a client that prints fewer digits still requests
/// all data.
/// `boxes`  at least one
[[nodiscard]] nlohmann::json spatial_extent(std::span<const geo::BoundingBox> boxes);

/// A period including both ends; an empty end is open.
struct ExtentPeriod {
  std::optional<core::UtcTime> from;
  std::optional<core::UtcTime> to;
};

/// The temporal extent: first the period of all parts, then the separate periods, if there are several but
/// not many.
/// `periods`  at least one
[[nodiscard]] nlohmann::json temporal_extent(std::span<const ExtentPeriod> periods);

}  // namespace floeplan::routes

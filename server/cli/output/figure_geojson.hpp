#pragma once

#include <nlohmann/json_fwd.hpp>

#include "engine/reproduction/figure.hpp"

namespace floeplan::cli {

/// The figure as GeoJSON (RFC 7946): paths, start, goal, obstacles, arrows of the current. The paper's waters
/// lie nowhere on Earth; for maps they are laid on the equator at 0 E, and each feature keeps its plane
/// coordinates in the property plane_xy, as the collection's note says.
[[nodiscard]] nlohmann::json figure_geojson(const reproduction::Figure& figure);

}  // namespace floeplan::cli

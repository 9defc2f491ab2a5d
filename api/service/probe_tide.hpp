#pragma once

#include <optional>
#include <vector>

#include "api/codec/documents/probe_document.hpp"
#include "engine/core/units.hpp"
#include "engine/geo/lon_lat.hpp"
#include "storage/repository/datasets/dataset.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::service {

/// Greatest distance of a tide station that is used for a place.
inline constexpr core::Metres probe_station_range{20'000.0};

/// The tide at a place and a time: from all gridded models that cover the place (for a constituent in several
/// models, the newest counts); if there are none, from the nearest station within `probe_station_range`.
[[nodiscard]] codec::Probe::Tide probe_tide(sql::Connection& db,
                                            const std::vector<repository::Dataset>& datasets,
                                            geo::LonLat place, core::UtcTime time);

/// The water level at a place and a time: from the first of the datasets whose grid or mesh has a value there; if none
/// has, from the nearest station within `probe_station_range` that has one.
[[nodiscard]] codec::Probe::WaterLevel probe_water_level(sql::Connection& db,
                                                         const std::vector<repository::Dataset>& datasets,
                                                         geo::LonLat place, core::UtcTime time);

}  // namespace floeplan::service

#pragma once

#include <optional>
#include <vector>

#include "api/codec/documents/probe_document.hpp"
#include "engine/core/units.hpp"
#include "engine/geo/lon_lat.hpp"
#include "storage/repository/datasets/dataset.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::service {

/// A station of the tide farther away than this says nothing of the place.
inline constexpr core::Metres probe_station_range{20'000.0};

/// The tide at a place and a time, from all models on a grid that cover the place (of two that have a line the newer
/// counts) or, where none does, from the nearest station within `probe_station_range`.
[[nodiscard]] codec::Probe::Tide probe_tide(sql::Connection& db,
                                            const std::vector<repository::Dataset>& datasets,
                                            geo::LonLat place, core::UtcTime time);

}  // namespace floeplan::service

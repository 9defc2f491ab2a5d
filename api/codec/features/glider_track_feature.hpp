#pragma once

#include <nlohmann/json_fwd.hpp>

#include "storage/repository/features/glider_track_repository.hpp"

namespace floeplan::codec {

/// Largest number of points in a feature, which gives some megabytes of JSON.
inline constexpr std::size_t most_track_points = 20'000;

/// A glider's track as a GeoJSON Feature: a line with heights (minus the depths) if any depth is known, the
/// time and depth of each position, and the depth-averaged currents with their frame. A track of one position
/// becomes a line from there to there.
[[nodiscard]] nlohmann::json glider_track_feature(const repository::StoredGliderTrack& stored);

}  // namespace floeplan::codec

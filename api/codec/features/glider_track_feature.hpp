#pragma once

#include <nlohmann/json_fwd.hpp>

#include "storage/repository/features/glider_track_repository.hpp"

namespace floeplan::codec {

/// Points that a feature has at most: some megabytes of JSON.
inline constexpr std::size_t most_track_points = 20'000;

/// A glider's way as a GeoJSON Feature: a line with heights (minus the depths) where any depth is known, the time and
/// the depth of each of its places, and the depth-averaged currents with their frame. A way of one place is a line from there to there.
[[nodiscard]] nlohmann::json glider_track_feature(const repository::StoredGliderTrack& stored);

}  // namespace floeplan::codec

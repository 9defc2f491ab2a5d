#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/geo/bounding_box.hpp"
#include "engine/geo/lon_lat.hpp"
#include "engine/geo/velocity.hpp"
#include "engine/ocean/currents/vehicle_axes.hpp"

namespace floeplan::ocean {

/// The position of a glider at one time.
struct TrackPoint {
  core::UtcTime time;
  geo::LonLat place;
  std::optional<core::Metres> depth{};  // below the surface; empty: unknown
  bool fixed{true};                     // true: measured; false: dead reckoning, or interpolated

  friend bool operator==(const TrackPoint&, const TrackPoint&) = default;
};

/// Mean current over the depths of one dive. Place and time are the middle of the dive.
struct DepthAveragedCurrent {
  core::UtcTime time;
  geo::LonLat place;
  geo::VelocityEn current;

  friend bool operator==(const DepthAveragedCurrent&, const DepthAveragedCurrent&) = default;
};

/// The frame of the currents of a track.
enum class CurrentFrame {
  stated,   // east and north by name; not every producer has rotated them from the vehicle's axes
  turned,   // true east and north, rotated by us from the vehicle's axes
  vehicle,  // the vehicle's axes, although named east and north; data stored before they were rotated
};

/// Names in files: "stated", "true" or "vehicle".
[[nodiscard]] std::string_view frame_name(CurrentFrame frame);
[[nodiscard]] std::optional<CurrentFrame> parse_current_frame(std::string_view name);

/// The data of a glider's route: points and currents, each oldest first.
struct GliderTrack {
  std::string glider;  // name in its file, or that of its deployment
  std::vector<TrackPoint> points;
  std::vector<DepthAveragedCurrent> currents;
  CurrentFrame frame{CurrentFrame::stated};
  std::optional<VehicleAxes> turned_from{};  // axes of the first current; empty unless `turned`

  friend bool operator==(const GliderTrack&, const GliderTrack&) = default;
};

/// The greatest depth of all points; empty if no point has a depth.
[[nodiscard]] std::optional<core::Metres> deepest(const std::vector<TrackPoint>& points);

/// Mean of the currents with equal weights; empty for none.
[[nodiscard]] std::optional<geo::VelocityEn> mean_current(const std::vector<DepthAveragedCurrent>& currents);

/// Smallest box around all points and all places of currents.
/// Errors   std::invalid_argument for a track without either
[[nodiscard]] geo::BoundingBox bounding_box(const GliderTrack& track);

/// At most `most` of the points: the first and the last. The rest is divided into as many equal parts as fit,
/// and of each part the shallowest and the deepest point are kept. So the dives keep their depth.
/// Edges    a point without a depth counts as shallow; `most` below 4 gives only the first and the last point
[[nodiscard]] std::vector<TrackPoint> thinned(const std::vector<TrackPoint>& points, std::size_t most);

/// Depths of all points in metres. Unknown ones are interpolated in time between the known ones before and
/// after, or take the value of the only known neighbour.
/// Outside  empty if no depth is known
[[nodiscard]] std::vector<double> depths_along(const std::vector<TrackPoint>& points);

/// Place of a vehicle at a time, on straight lines from point to point. Before the first point and after the
/// last it stays there.
/// Errors   std::invalid_argument for no points
[[nodiscard]] geo::LonLat place_at(const std::vector<TrackPoint>& points, core::UtcTime time);

}  // namespace floeplan::ocean

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

/// Where a glider was at a moment.
struct TrackPoint {
  core::UtcTime time;
  geo::LonLat place;
  std::optional<core::Metres> depth{};  // below the surface; empty: not known
  bool fixed{true};  // measured; false: reckoned by the vehicle, or between two other places

  friend bool operator==(const TrackPoint&, const TrackPoint&) = default;
};

/// Mean current over the depths of one dive, at the middle of the dive.
struct DepthAveragedCurrent {
  core::UtcTime time;
  geo::LonLat place;
  geo::VelocityEn current;

  friend bool operator==(const DepthAveragedCurrent&, const DepthAveragedCurrent&) = default;
};

/// In which frame the currents of a track are.
enum class CurrentFrame {
  stated,  // east and north as their file calls them; not every producer turned them from the vehicle's own axes
  turned,   // true east and north: turned from the vehicle's own axes
  vehicle,  // the vehicle's own axes, under the names of east and north: stored before they were turned
};

/// "stated", "true" or "vehicle".
[[nodiscard]] std::string_view frame_name(CurrentFrame frame);
[[nodiscard]] std::optional<CurrentFrame> parse_current_frame(std::string_view name);

/// What a glider's data tell of its way: points and currents, each oldest first.
struct GliderTrack {
  std::string glider;  // the name that its file gives it, or its deployment
  std::vector<TrackPoint> points;
  std::vector<DepthAveragedCurrent> currents;
  CurrentFrame frame{CurrentFrame::stated};
  std::optional<VehicleAxes> turned_from{};  // of the first current; empty unless turned

  friend bool operator==(const GliderTrack&, const GliderTrack&) = default;
};

/// The greatest depth of all points; empty where none has one.
[[nodiscard]] std::optional<core::Metres> deepest(const std::vector<TrackPoint>& points);

/// Mean of the currents, each counting the same; empty of none.
[[nodiscard]] std::optional<geo::VelocityEn> mean_current(const std::vector<DepthAveragedCurrent>& currents);

/// Smallest box around the points and the places of the currents.
/// Errors   std::invalid_argument for a track without any
[[nodiscard]] geo::BoundingBox bounding_box(const GliderTrack& track);

/// At most `most` of the points: the first and the last, and of each of as many equal parts as fit the shallowest and
/// the deepest, so that the dives keep their depth.
/// Edges    a point without a depth counts as shallow; `most` below 4 gives the ends alone
[[nodiscard]] std::vector<TrackPoint> thinned(const std::vector<TrackPoint>& points, std::size_t most);

/// Depths of all points in metres: those that are not known in proportion to time between the two that are, or as the
/// only one beside them.
/// Outside  empty where no depth is known
[[nodiscard]] std::vector<double> depths_along(const std::vector<TrackPoint>& points);

/// Where a vehicle is at a time, going straight from point to point; at an end before the first and after the last.
/// Errors   std::invalid_argument without any point
[[nodiscard]] geo::LonLat place_at(const std::vector<TrackPoint>& points, core::UtcTime time);

}  // namespace floeplan::ocean

#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "engine/core/units.hpp"
#include "engine/core/violation.hpp"

namespace floeplan::vehicle {

/// What the planner and the mission writer know of a kind of glider.
struct GliderProfile {
  std::string name;
  std::string title;
  core::MetresPerSecond speed_through_water{0.35};  // horizontal
  core::Metres dive_depth{200.0};
  core::Metres depth_rating{200.0};
  core::Metres minimum_working_depth{20.0};  // shallower water is closed to it
  core::Metres altimeter_margin{10.0};       // kept above the sea bed
  int max_waypoints_per_list{8};             // of one goto list

  [[nodiscard]] core::Violations violations() const;  // empty when valid, otherwise all of them
};

/// The profiles that come with the product, in a fixed order; the first is the default.
[[nodiscard]] std::span<const GliderProfile> known_profiles();

[[nodiscard]] std::optional<GliderProfile> find_profile(std::string_view name);

}  // namespace floeplan::vehicle

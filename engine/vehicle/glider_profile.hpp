#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/core/violation.hpp"
#include "engine/vehicle/dive_band.hpp"
#include "engine/vehicle/energy_model.hpp"
#include "engine/vehicle/glide.hpp"
#include "engine/vehicle/thruster.hpp"

namespace floeplan::vehicle {

/// The data on one type of glider for the planner and the mission writer.
struct GliderProfile {
  std::string name;
  std::string title;
  core::MetresPerSecond speed_through_water{0.35};  // horizontal, with the buoyancy engine
  core::Radians pitch{0.4538};                      // of dives and climbs
  core::CubicMetres buoyancy{230e-6};               // volume pumped above and below neutral
  Hydrodynamics hydrodynamics{};
  core::Metres climb_to{5.0};
  core::Metres dive_depth{200.0};
  core::Metres depth_rating{200.0};
  core::Metres minimum_working_depth{20.0};  // shallower water is closed
  core::Metres altimeter_margin{10.0};       // kept above the sea bed
  EnergyModel energy{};
  std::optional<Thruster> thruster{};
  int max_waypoints_per_list{8};  // of one goto list

  [[nodiscard]] core::Violations violations() const;  // empty when valid, otherwise all of them

  [[nodiscard]] DiveLimits dive_limits() const { return {climb_to, dive_depth, altimeter_margin}; }
  /// Shallowest water in which it may work, including room for the smallest saw-tooth above the margin.
  [[nodiscard]] core::Metres least_water() const;
  /// Least water from an upper turn below ice or a keel to the sea bed: as much as otherwise from the
  /// surface, and room for the smallest saw-tooth above the margin.
  [[nodiscard]] core::Metres least_water_below_turn() const;
  /// Vertical speed on the path of its pitch at this horizontal speed.
  /// Precondition  the profile is valid
  [[nodiscard]] core::MetresPerSecond vertical_speed(core::MetresPerSecond horizontal) const;

  friend bool operator==(const GliderProfile&, const GliderProfile&) = default;
};

/// Limits on the pitch of a profile: flatter gives hardly any lift, steeper hardly any way.
inline constexpr double least_pitch_deg = 10.0;
inline constexpr double most_pitch_deg = 60.0;

/// The profiles that are part of the product, in a fixed order; the first is the default.
[[nodiscard]] std::span<const GliderProfile> known_profiles();

[[nodiscard]] std::optional<GliderProfile> find_profile(std::string_view name);

/// The known profiles that differ from the one of this name only by their depth class and need less water,
/// the deepest class first. Empty for unknown names.
[[nodiscard]] std::vector<GliderProfile> profiles_for_shallower_water(std::string_view name);

}  // namespace floeplan::vehicle

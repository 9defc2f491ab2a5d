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

/// What the planner and the mission writer know of a kind of glider.
struct GliderProfile {
  std::string name;
  std::string title;
  core::MetresPerSecond speed_through_water{0.35};  // horizontal, on the buoyancy drive
  core::Radians pitch{0.4538};                      // of dives and climbs
  core::CubicMetres buoyancy{230e-6};               // pumped to either side of neutral
  Hydrodynamics hydrodynamics{};
  core::Metres climb_to{5.0};
  core::Metres dive_depth{200.0};
  core::Metres depth_rating{200.0};
  core::Metres minimum_working_depth{20.0};  // shallower water is closed to it
  core::Metres altimeter_margin{10.0};       // kept above the sea bed
  EnergyModel energy{};
  std::optional<Thruster> thruster{};
  int max_waypoints_per_list{8};  // of one goto list

  [[nodiscard]] core::Violations violations() const;  // empty when valid, otherwise all of them

  [[nodiscard]] DiveLimits dive_limits() const { return {climb_to, dive_depth, altimeter_margin}; }
  /// Shallowest water it may work in: room for the lowest saw-tooth above the margin, too.
  [[nodiscard]] core::Metres least_water() const;
  /// Least water between an upper turn below ice or a keel and the sea bed: as much as it otherwise needs from the
  /// surface, and room for the lowest saw-tooth above the margin.
  [[nodiscard]] core::Metres least_water_below_turn() const;
  /// Rate of depth while it makes this horizontal speed along the path of its pitch.
  /// Precondition  the profile is valid
  [[nodiscard]] core::MetresPerSecond vertical_speed(core::MetresPerSecond horizontal) const;

  friend bool operator==(const GliderProfile&, const GliderProfile&) = default;
};

/// Flattest and steepest pitch that a profile may have: flatter there is hardly lift, steeper hardly way.
inline constexpr double least_pitch_deg = 10.0;
inline constexpr double most_pitch_deg = 60.0;

/// The profiles that come with the product, in a fixed order; the first is the default.
[[nodiscard]] std::span<const GliderProfile> known_profiles();

[[nodiscard]] std::optional<GliderProfile> find_profile(std::string_view name);

/// The known profiles that differ from the known one of this name by their depth class alone and need less water, what
/// needs the most of them first; none for other names.
[[nodiscard]] std::vector<GliderProfile> profiles_for_shallower_water(std::string_view name);

}  // namespace floeplan::vehicle

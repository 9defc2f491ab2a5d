#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/core/violation.hpp"
#include "engine/vehicle/drive.hpp"
#include "engine/vehicle/glider_profile.hpp"

namespace floeplan::planning {

/// The cost that a plan minimises: a weighted sum of travel time in seconds, energy in joules and expected
/// encounters with icebergs.
struct Objective {
  double of_time{1.0};
  double of_energy{0.0};
  double of_encounters{0.0};

  [[nodiscard]] bool is_time() const { return of_energy == 0.0 && of_encounters == 0.0; }
  [[nodiscard]] double cost(core::Seconds time, core::Joules energy, double encounters = 0.0) const {
    return of_time * time.count() + of_energy * energy.value + of_encounters * encounters;
  }
  friend bool operator==(const Objective&, const Objective&) = default;
};

inline constexpr Objective time_objective{1.0, 0.0, 0.0};
inline constexpr Objective energy_objective{0.0, 1.0, 0.0};

enum class ThrusterUse {
  automatic,  // the objective decides for each leg
  on,
  off
};

[[nodiscard]] std::string thruster_use_name(ThrusterUse use);
[[nodiscard]] std::optional<ThrusterUse> parse_thruster_use(std::string_view name);

/// The rules of a request on energy.
struct EnergyRules {
  Objective objective{};
  ThrusterUse thruster{ThrusterUse::automatic};
  bool require_battery{false};  // true: a plan beyond the battery is refused; false: it gets a warning

  [[nodiscard]] core::Violations violations(const vehicle::GliderProfile& profile) const;
};

/// The kinds of propulsion that a leg may use, at least one. If only time counts, the slower of two is left
/// out, because it never arrives earlier.
[[nodiscard]] std::vector<vehicle::Drive> drives(const EnergyRules& rules,
                                                 const vehicle::GliderProfile& profile);

/// Horizontal speed through the water. Precondition: the vehicle has this propulsion.
[[nodiscard]] core::MetresPerSecond drive_speed(const vehicle::GliderProfile& profile, vehicle::Drive drive);
/// "buoyancy", "thruster", and back.
[[nodiscard]] std::string drive_name(vehicle::Drive drive);
[[nodiscard]] std::optional<vehicle::Drive> parse_drive(const std::string& name);

}  // namespace floeplan::planning

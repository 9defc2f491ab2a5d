#pragma once

#include <compare>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/geo/lon_lat.hpp"
#include "engine/mission/writing/goto_lists.hpp"
#include "engine/mission/writing/shoals.hpp"
#include "engine/planning/problem/under_ice_rules.hpp"
#include "engine/vehicle/glider_profile.hpp"

namespace floeplan::mission {

/// Version of the firmware that will read the files.
struct Firmware {
  int major{10};
  int minor{5};

  friend auto operator<=>(const Firmware&, const Firmware&) = default;
};

/// Data for work under ice that are not in the plan.
struct UnderIce {
  std::vector<geo::LonLat> safe_places;  // open water to head for in an emergency; one to eight places
  /// Default: the depth of the deepest ice that the plan passes below, but at least the value of the vendor's
  /// stock settings.
  std::optional<core::Metres> deepest_expected_iceberg{};
  core::Metres margin_below_ice{planning::UnderIceRules{}.margin_below_ice};  // as in the plan's request
};

struct MissionSetOptions {
  GotoListOptions lists{};           // `first_number` also numbers the other files
  std::string name{"plan"};          // of the mission, without extension
  vehicle::GliderProfile vehicle{};  // with the dive depth
  Firmware firmware{};
  std::optional<UnderIce> under_ice{};
  /// The interval of surfacings in the plan's request; in open water the mission uses the same.
  std::optional<core::Seconds> surfacing_interval{};
  std::vector<std::optional<Shoal>> shoals{};  // for each leg, from shoals_along; empty: unknown
};

}  // namespace floeplan::mission

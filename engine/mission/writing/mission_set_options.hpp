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

/// Version of the firmware that shall read the files.
struct Firmware {
  int major{10};
  int minor{5};

  friend auto operator<=>(const Firmware&, const Firmware&) = default;
};

/// What work under ice needs besides the plan.
struct UnderIce {
  std::vector<geo::LonLat> safe_places;  // open water to head for in an emergency, one to eight
  /// Default: as deep as what the plan passes below, or as in the vendor's stock settings where that is deeper.
  std::optional<core::Metres> deepest_expected_iceberg{};
  core::Metres margin_below_ice{planning::UnderIceRules{}.margin_below_ice};  // that the plan was made with
};

struct MissionSetOptions {
  GotoListOptions lists{};           // `first_number` numbers the other files too
  std::string name{"plan"};          // of the mission, without its ending
  vehicle::GliderProfile vehicle{};  // with the depth to dive to
  Firmware firmware{};
  std::optional<UnderIce> under_ice{};
  /// The interval at which the plan was asked to surface; in open water the mission surfaces as often.
  std::optional<core::Seconds> surfacing_interval{};
  std::vector<std::optional<Shoal>> shoals{};  // of each leg, as shoals_along gives them; empty: not known
};

}  // namespace floeplan::mission

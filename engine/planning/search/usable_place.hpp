#pragma once

#include <optional>
#include <stop_token>

#include "engine/planning/cost/planning_domain.hpp"

namespace floeplan::planning::search {

/// Usable places farther away are not looked for: a route from there would be another mission. A judgement.
inline constexpr core::Metres farthest_usable_place{100'000.0};

/// The nearest usable place at the departure, in rings of the safety map's cells around an unusable one: the centre
/// of a cell that is open as a whole. Empty if there is none within the farthest distance.
[[nodiscard]] std::optional<geo::LonLat> nearest_usable_place(const cost::PlanningDomain& domain,
                                                              geo::PlanePoint around);

/// The same among the places from which open water leads to `other` in steps of those cells; closures that end count
/// as open. Empty if there is none, or once `stop` is requested.
[[nodiscard]] std::optional<geo::LonLat> nearest_usable_place_towards(const cost::PlanningDomain& domain,
                                                                      geo::PlanePoint around,
                                                                      geo::PlanePoint other,
                                                                      const std::stop_token& stop);

}  // namespace floeplan::planning::search

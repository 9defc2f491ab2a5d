#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/geo/lon_lat.hpp"
#include "engine/geo/velocity.hpp"
#include "engine/messages/message.hpp"
#include "engine/ocean/dataset_ref.hpp"
#include "engine/planning/problem/energy_use.hpp"
#include "engine/planning/problem/keel.hpp"
#include "engine/planning/problem/plan_request.hpp"
#include "engine/planning/problem/refinement_report.hpp"
#include "engine/planning/problem/surfacing_plan.hpp"
#include "engine/planning/problem/uncertainty_report.hpp"
#include "engine/vehicle/drive.hpp"

namespace floeplan::planning {

/// A place of the plan and the leg that leads to it. The first waypoint is the start and has no leg.
struct Waypoint {
  geo::LonLat place;
  core::UtcTime eta;                       // time of arrival
  std::optional<core::Metres> leg_length;  // geodesic on WGS84
  std::optional<double> course_deg;        // of the leg at its start, clockwise from true north
  std::optional<core::MetresPerSecond> speed_over_ground;  // mean over the leg
  std::optional<core::Metres> depth;                       // of the sea bed at `place`
  std::optional<double> iceberg_encounters;  // expected on the leg and the hold before it; empty if
                                             // no iceberg is known
  std::optional<core::Joules> energy{};      // drawn since the departure
  std::optional<vehicle::Drive> drive{};     // of the leg
  std::optional<core::MetresPerSecond> speed_through_water{};  // horizontal, on the leg
  /// Mean current over the leg and over the depths flown. Empty at the start, where no currents are known,
  /// and in plans of versions that did not store it.
  std::optional<geo::VelocityEn> current{};
  core::Seconds wait{};  // hold at `place` between arrival and next leg; draws energy as under way
};

/// Figures about the search, for comparison and to tell its limits.
struct SearchStatistics {
  std::int64_t vertices{};
  std::int64_t edges{};  // directed edges, open by depth, land and static obstacles
  std::int64_t edge_evaluations{};
  std::int64_t expansions{};
  std::int64_t reinsertions{};
  /// Something was closed when the vehicle, which may not hold, arrived there. It may reopen in time for an
  /// earlier route.
  bool holds_may_help{false};
  /// The goal reopens at the arrival. So no other route arrives earlier, unless it is faster by a twentieth.
  bool none_is_earlier{false};
  /// The search reached its limit on stored arrivals. A better route may exist; if none was found, some route
  /// may.
  bool cut_short{false};
  /// Upper bound of how much earlier a better route might arrive, on the grid and before refinement; empty:
  /// unknown.
  std::optional<core::Seconds> possible_gain{};
  core::Seconds duration{};  // set by the caller, who has a clock
};

/// Least distances along the whole route; empty if there are no data about the obstacle.
struct Clearances {
  std::optional<core::Metres> iceberg;  // from the hull's edge, not from the centre
  std::string
      nearest_iceberg{};  // its name; empty: it has none, or a version made the plan that did not store it
  std::optional<core::Metres> land;
  std::optional<core::Metres> bottom;  // from the deepest point of the dive to the sea bed
};

/// The order in which the via points are visited.
struct ViaOrder {
  std::vector<std::size_t> vias;  // indices into the request's via points
  bool exact{};                   // no other order is better by the travel times on a coarse grid
};

/// The energy that the plan needs and that the battery has.
struct PlanEnergy {
  EnergyUse use;
  core::Joules usable;
};

/// An iceberg that the vehicle passes under. From entering to leaving its disc the dives turn below the keel,
/// and the vehicle must not surface.
struct PassedUnder {
  std::string iceberg;  // its name, or its number in the source
  Keel keel;
  core::UtcTime from;
  core::UtcTime until;
};

/// The effect of the weight on encounters with icebergs: figures of the plan without it, for comparison.
struct EncounterTrade {
  core::Seconds weight{};  // travel time that one encounter counts as
  core::Seconds time_before{};
  double encounters_before{};
};

/// A route with times.
struct Plan {
  Method method{};
  std::string vehicle;
  core::UtcTime departure;
  core::UtcTime arrival;
  core::Metres distance;
  std::vector<Waypoint> waypoints;
  std::optional<ViaOrder> via_order;             // only if the request left the order open
  std::optional<UncertaintyReport> uncertainty;  // only if the currents are uncertain
  SearchStatistics search;
  std::optional<RefinementReport> refinement;  // empty: not refined, or the route was given
  Clearances clearances;
  std::optional<double>
      iceberg_encounters;  // expected number of times, on the whole route, within the margin of a hull
  std::vector<PassedUnder> passed_under;          // in the order of the passages
  std::optional<EncounterTrade> encounter_trade;  // only if encounters have a weight
  std::optional<SurfacingPlan> surfacing;         // only with ice data, or if surfacings were requested
  std::optional<PlanEnergy> energy;
  std::optional<double> optimality_gap;
  std::string optimality_gap_reason;          // why there is no gap; empty if there is one
  core::MetresPerSecond strongest_current{};  // in the searched area
  std::vector<ocean::DatasetRef> datasets;
  std::vector<messages::Message> messages;

  [[nodiscard]] core::Seconds travel_time() const { return arrival - departure; }
};

}  // namespace floeplan::planning

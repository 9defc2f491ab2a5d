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
  core::UtcTime eta;                       // of the arrival
  std::optional<core::Metres> leg_length;  // geodesic on WGS84
  std::optional<double> course_deg;        // of the leg at its start, clockwise from true north
  std::optional<core::MetresPerSecond> speed_over_ground;  // mean over the leg
  std::optional<core::Metres> depth;                       // of the sea bed here
  std::optional<double> iceberg_encounters;  // expected on the leg and in the wait before it; empty where
                                             // no iceberg is known
  std::optional<core::Joules> energy{};      // drawn since the departure
  std::optional<vehicle::Drive> drive{};     // of the leg
  std::optional<core::MetresPerSecond> speed_through_water{};  // horizontal, on the leg
  /// Mean over the leg, averaged over the depths flown; empty at the start, where no currents are known, and in plans
  /// stored before it was kept.
  std::optional<geo::VelocityEn> current{};
  core::Seconds wait{};  // here, after the arrival and before the next leg; draws energy as if under way
};

/// What the search did, for comparison and for honest progress.
struct SearchStatistics {
  std::int64_t vertices{};
  std::int64_t edges{};  // directed, open by depth, land and static obstacles
  std::int64_t edge_evaluations{};
  std::int64_t expansions{};
  std::int64_t reinsertions{};
  /// Something was closed when the vehicle, which never holds, came to it, and may open in time for a way that is
  /// earlier.
  bool holds_may_help{false};
  /// Nobody is at the goal earlier, whatever the grid, unless it came faster by a twentieth: it opens then.
  bool none_is_earlier{false};
  /// It ended at its bound on arrivals kept: a better way, or where none was found a way, may exist.
  bool cut_short{false};
  /// By how much the better way, on the grid and before refinement, might arrive earlier at most, where that is known.
  std::optional<core::Seconds> possible_gain{};
  core::Seconds duration{};  // filled by the caller that owns a clock
};

/// Least distances along the whole route; empty where nothing of the kind is known.
struct Clearances {
  std::optional<core::Metres> iceberg;  // from the hull's edge, not from the centre
  std::string
      nearest_iceberg{};  // its name; empty: it has none, or a version made the plan that did not store it
  std::optional<core::Metres> land;
  std::optional<core::Metres> bottom;  // from the deepest point of the dive to the sea bed
};

/// In which order the places to visit are visited.
struct ViaOrder {
  std::vector<std::size_t> vias;  // indices of the request's
  bool exact{};  // no other order would be better, as far as travel times on a coarse grid tell
};

/// What the plan draws from the battery, and what the battery gives.
struct PlanEnergy {
  EnergyUse use;
  core::Joules usable;
};

/// An iceberg that the vehicle passes under: from entering its disc to leaving it the dives turn below the keel, and
/// nothing may surface.
struct PassedUnder {
  std::string iceberg;  // its name, or number in its source
  Keel keel;
  core::UtcTime from;
  core::UtcTime until;
};

/// What the weight on encounters with icebergs did: the plan without it, for comparison.
struct EncounterTrade {
  core::Seconds weight{};  // of one encounter
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
  std::optional<ViaOrder> via_order;             // when the request left the order open
  std::optional<UncertaintyReport> uncertainty;  // when the currents are not certain
  SearchStatistics search;
  std::optional<RefinementReport> refinement;  // empty: the way is the grid's, or was given
  Clearances clearances;
  std::optional<double>
      iceberg_encounters;  // expected in all: how often within the margin of a hull, on the average
  std::vector<PassedUnder> passed_under;          // in the order they are come to
  std::optional<EncounterTrade> encounter_trade;  // where encounters have a weight
  std::optional<SurfacingPlan> surfacing;  // where something is known of ice or surfacings were asked for
  std::optional<PlanEnergy> energy;
  std::optional<double> optimality_gap;
  std::string optimality_gap_reason;          // why the gap is not given; empty when it is
  core::MetresPerSecond strongest_current{};  // in the area that the way was looked for in
  std::vector<ocean::DatasetRef> datasets;
  std::vector<messages::Message> messages;

  [[nodiscard]] core::Seconds travel_time() const { return arrival - departure; }
};

}  // namespace floeplan::planning

#pragma once

#include <optional>
#include <span>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "engine/core/violation.hpp"
#include "engine/simulation/flight/flight_record.hpp"
#include "engine/simulation/logs/glider_log.hpp"
#include "engine/simulation/vehicle/glider_motion.hpp"
#include "engine/vehicle/glider_profile.hpp"

namespace floeplan::simulation {

/// One quantity of a dive, as the vehicle logged it and as it was simulated.
struct Compared {
  double logged{};
  double simulated{};

  /// Deviation as a share of the logged value.
  [[nodiscard]] double deviation_share() const;
};

/// A logged dive beside its simulation.
struct SegmentComparison {
  Compared under_water_s{};
  Compared dives{};      // begun
  Compared speed_m_s{};  // net, horizontal, through the water: over ground less the depth-averaged current
  Compared over_ground_m{};  // from the dive to the first position after it
  double apart_m{};          // between both first positions
  double apart_share{};      // of the logged way over ground
  double parasite_drag{};    // that it was flown with
  std::string ended{};       // why the simulated flight ended
};

/// The source of the parasite drag in the simulation of a logged dive: the log, where its rates of depth show one, or
/// the profile.
/// Source   fitting drag to the rates of depth: Merckelbach, Smeed and Griffiths 2010, doi:10.1175/2009JTECHO710.1.
///          Between two vehicles of one kind it differs by a third, by growth, sensors and trim
enum class DragOf { log, profile };

/// Flies a logged dive again: its start, waypoints, dive settings and trim, in water that moves as the vehicle's own
/// depth-averaged current of that dive, with the current that the vehicle reckoned with and perfect sensors. It is told
/// to come up when the real one was on its last climb, for what sends a vehicle up is not in its log.
/// Errors   settings of the log beyond any vehicle
[[nodiscard]] tl::expected<SegmentComparison, core::Violations> compare_segment(
    const LoggedSegment& segment, const vehicle::GliderProfile& vehicle, const HullMotion& hull, DragOf drag);

/// Medians of the absolute deviations of several dives, and of their drags.
struct ComparisonSummary {
  double under_water_share{};
  double dives_share{};
  double speed_share{};
  double apart_share{};
  double parasite_drag{};  // that they were flown with

  /// Whether each deviation is a tenth or less.
  [[nodiscard]] bool within_a_tenth() const;
};

/// Precondition   one comparison or more
[[nodiscard]] ComparisonSummary summary_of(std::span<const SegmentComparison> comparisons);

}  // namespace floeplan::simulation

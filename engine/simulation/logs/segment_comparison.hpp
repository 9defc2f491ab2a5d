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

/// One quantity of a dive: logged and simulated.
struct Compared {
  double logged{};
  double simulated{};

  /// Deviation of the simulation, as a share of the logged value.
  [[nodiscard]] double deviation_share() const;
};

/// A logged dive compared with its simulation.
struct SegmentComparison {
  Compared under_water_s{};
  Compared dives{};          // number of dives begun
  Compared speed_m_s{};      // horizontal, through the water: displacement over ground minus the mean current
  Compared over_ground_m{};  // distance from the dive to the first fix after it
  double apart_m{};          // distance between the logged and the simulated first fix
  double apart_share{};      // share of the logged distance over ground
  double parasite_drag{};    // used in the simulation
  std::string ended{};       // end of the simulated flight
};

/// Source of the parasite drag for the simulation of a logged dive: the log, if its vertical speeds give one,
/// or the profile.
/// Source   fitting drag to the vertical speeds: Merckelbach, Smeed and Griffiths 2010,
///          doi:10.1175/2009JTECHO710.1. Between two vehicles of one type it differs by a third, by growth,
///          sensors and trim
enum class DragOf { log, profile };

/// Simulates a logged dive: with its start, waypoints, dive settings and trim, in the vehicle's own mean
/// current of that dive, with the current that the vehicle assumed, and with perfect sensors. The simulated
/// vehicle surfaces when the real one was on its last climb, because the log does not say why a vehicle
/// surfaces.
/// Errors   settings of the log that are out of range for any vehicle
[[nodiscard]] tl::expected<SegmentComparison, core::Violations> compare_segment(
    const LoggedSegment& segment, const vehicle::GliderProfile& vehicle, const HullMotion& hull, DragOf drag);

/// Medians over several dives: of the absolute deviations of the simulation from the log, and of the drags.
struct ComparisonSummary {
  double under_water_share{};
  double dives_share{};
  double speed_share{};
  double apart_share{};
  double parasite_drag{};  // used in the simulations

  /// Whether each deviation is at most a tenth.
  [[nodiscard]] bool within_a_tenth() const;
};

/// Summary of the comparisons of several dives.
/// Precondition   `comparisons` has at least one element
[[nodiscard]] ComparisonSummary summary_of(std::span<const SegmentComparison> comparisons);

}  // namespace floeplan::simulation

#pragma once

#include <span>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "engine/core/violation.hpp"
#include "engine/simulation/logs/segment_comparison.hpp"
#include "storage/json/json.hpp"

namespace floeplan::codec {

inline constexpr const char* usual_compared_vehicle = "slocum-g3-200";
inline constexpr std::size_t most_logs = 100;            // in one request
inline constexpr std::size_t longest_log = 16UL << 20U;  // bytes

/// A log of a Slocum as text, and the dives that were read from it.
struct GliderLog {
  std::string name;
  std::string text{};
  std::vector<simulation::LoggedSegment> dives;
};

/// Inputs of process compare-flight.
struct CompareFlightInputs {
  std::vector<GliderLog> logs;
  vehicle::GliderProfile vehicle{};  // profile of a known vehicle
  simulation::DragOf drag{simulation::DragOf::log};
};

/// The known vehicle with this name; otherwise one violation that lists the known ones.
[[nodiscard]] tl::expected<vehicle::GliderProfile, core::Violation> compared_vehicle(const std::string& name);

/// Errors   all violations at once, also faults of the logs, each with the JSON pointer of its value relative
///          to `inputs`; faults of a log also have the line and the column
[[nodiscard]] tl::expected<CompareFlightInputs, core::Violations> parse_compare_flight_inputs(
    const nlohmann::json& inputs);

/// The inputs with all defaults filled in.
[[nodiscard]] nlohmann::json to_json(const CompareFlightInputs& inputs);

/// A logged dive with its simulation.
struct ComparedDive {
  std::string file;
  simulation::LoggedSegment logged;
  simulation::SegmentComparison compared;
};

/// Statistics over all dives.
/// Precondition   at least one dive
[[nodiscard]] simulation::ComparisonSummary summary_of(std::span<const ComparedDive> dives);

/// All dives, logged and simulated, and the medians of their deviations.
/// Precondition   at least one dive
[[nodiscard]] nlohmann::json comparison_document(std::span<const ComparedDive> dives);

}  // namespace floeplan::codec

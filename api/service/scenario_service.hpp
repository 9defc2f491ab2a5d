#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <stop_token>

#include "api/codec/inputs/scenario_inputs.hpp"
#include "engine/core/executor.hpp"
#include "engine/core/progress.hpp"

namespace floeplan::service {

/// Simulates flights through random icebergs that the plan does not know (simulation::random_icebergs), each
/// run with its own seed; stores nothing. Common to API and command line.
/// Returns  the end of each flight and statistics; independent of the executor. With the avoidance
///          system, collisions that full knowledge could not have prevented are counted separately
///          (`beyond_help`); each run that gave up states why, and whether it arrives in the same water
///          without icebergs. {"status": "cancelled"} if `stop` was requested
[[nodiscard]] nlohmann::json fly_scenario_document(const codec::ScenarioInputs& asked,
                                                   const core::Executor& executor,
                                                   const std::stop_token& stop,
                                                   const core::ProgressCallback& progress);

}  // namespace floeplan::service

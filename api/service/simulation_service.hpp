#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <stop_token>
#include <tl/expected.hpp>

#include "api/codec/inputs/simulate_inputs.hpp"
#include "engine/core/executor.hpp"
#include "engine/core/progress.hpp"
#include "engine/core/units.hpp"
#include "engine/core/violation.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::service {

/// Simulates a stored plan, once or many times, and stores the simulation. Common to API and command line.
/// Returns  the simulation's document: status "ok", or "cancelled" when `stop` was requested; then nothing is
///          stored
/// Errors   violations: an unknown plan, another vehicle than the plan's, faults of mission files, data that
///          do not cover the plan, inconsistent settings
/// Names    the simulation's id is a digest of its inputs, the plan and the data: the same request gives the
///          same id and the same bytes, whatever the executor
[[nodiscard]] tl::expected<nlohmann::json, core::Violations> simulate_plan_document(
    sql::Connection& db, const codec::SimulateInputs& inputs, const core::Executor& executor,
    const std::stop_token& stop, const core::ProgressCallback& progress, core::UtcTime now);

}  // namespace floeplan::service

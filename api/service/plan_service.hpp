#pragma once

#include <nlohmann/json_fwd.hpp>
#include <stop_token>
#include <tl/expected.hpp>

#include "api/codec/inputs/plan_inputs.hpp"
#include "api/service/kept_work.hpp"
#include "engine/core/executor.hpp"
#include "engine/core/progress.hpp"
#include "engine/core/units.hpp"
#include "engine/core/violation.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::service {

/// Plans a route in the stored data and stores the plan. Common to API and command line. The plan does not depend
/// on the executor. `kept` has the caches of the store of `db`, borrowed; null: no caches.
/// Returns  the plan document: status "ok", or "infeasible" with the reason ("cancelled" when `stop` was
///          requested); if a plan with the same id is already stored, its document
/// Errors   violations of the choice of data (unknown id, wrong kind, no intersection with the area)
/// Names    the plan's id is codec::plan_identity: the same request on the same data gives the same id
[[nodiscard]] tl::expected<nlohmann::json, core::Violations> plan_route_document(
    sql::Connection& db, const codec::PlanInputs& inputs, const core::Executor& executor,
    const std::stop_token& stop, const core::ProgressCallback& progress, core::UtcTime now,
    KeptWork* kept = nullptr);

/// Evaluates a given route in the stored data; stores nothing.
/// Returns  a document of the same shape, without a plan_id
/// Errors   as above; also for a plan_id that is not stored
[[nodiscard]] tl::expected<nlohmann::json, core::Violations> evaluate_route_document(
    sql::Connection& db, codec::EvaluateInputs inputs, const std::stop_token& stop, KeptWork* kept = nullptr);

}  // namespace floeplan::service

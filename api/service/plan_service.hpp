#pragma once

#include <nlohmann/json_fwd.hpp>
#include <stop_token>
#include <tl/expected.hpp>

#include "api/codec/inputs/plan_inputs.hpp"
#include "api/service/kept_work.hpp"
#include "engine/core/progress.hpp"
#include "engine/core/units.hpp"
#include "engine/core/violation.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::service {

/// Plans a route in the stored data and stores the plan; one function for API and command line.
/// `workers`: threads that the planner may use; the plan is the same with any number of them.
/// `kept` is of the store that `db` is connected to, and borrowed; null: everything is read and laid out anew.
/// Returns  the plan document: status "ok", or "infeasible" with the reason ("cancelled" when `stop` was
///          requested); of a plan that was stored before under the same id that one's
/// Errors   violations of the choice of data (unknown id, wrong kind, nothing in common with the area)
/// Names    the plan's id is codec::plan_identity: the same request on the same data gives the same id
[[nodiscard]] tl::expected<nlohmann::json, core::Violations> plan_route_document(
    sql::Connection& db, const codec::PlanInputs& inputs, std::size_t workers, const std::stop_token& stop,
    const core::ProgressCallback& progress, core::UtcTime now, KeptWork* kept = nullptr);

/// Times a given route in the stored data; stores nothing.
/// Returns  a document of the same shape, without a plan_id
/// Errors   as above; also for a plan_id that is not stored
[[nodiscard]] tl::expected<nlohmann::json, core::Violations> evaluate_route_document(
    sql::Connection& db, codec::EvaluateInputs inputs, const std::stop_token& stop, KeptWork* kept = nullptr);

}  // namespace floeplan::service

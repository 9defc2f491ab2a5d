#pragma once

#include <nlohmann/json_fwd.hpp>
#include <stop_token>
#include <tl/expected.hpp>

#include "api/codec/inputs/reach_inputs.hpp"
#include "api/service/kept_work.hpp"
#include "engine/core/progress.hpp"
#include "engine/core/violation.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::service {

/// Computes isochrones in the stored data; stores nothing.
/// Returns  a GeoJSON FeatureCollection with status "ok", or a document with status "infeasible" and the reason
///          ("cancelled" when `stop` was requested)
/// Errors   violations of the choice of data, as for a plan
[[nodiscard]] tl::expected<nlohmann::json, core::Violations> reach_document(
    sql::Connection& db, const codec::ReachInputs& inputs, const std::stop_token& stop,
    const core::ProgressCallback& progress, KeptWork* kept = nullptr);

}  // namespace floeplan::service

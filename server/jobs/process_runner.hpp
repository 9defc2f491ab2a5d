#pragma once

#include <stop_token>
#include <string>
#include <tl/expected.hpp>

#include "api/service/ingest_service.hpp"
#include "api/service/kept_work.hpp"
#include "engine/core/executor.hpp"
#include "engine/core/progress.hpp"
#include "engine/core/units.hpp"
#include "storage/repository/work/job_repository.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::jobs {

/// The result of a job.
struct ProcessResult {
  std::string json;       // the results document
  std::string message{};  // why the document contains no route; empty if it contains one
};

/// Does the work of a job. Flights, departures and ensemble members run on the executor.
/// `kept`   caches of the store of `db`
/// Returns  must not be used when `stop` was requested meanwhile
/// Errors   why the work is not possible, for the user; std::exception when the machine fails or stored data
///          are damaged
[[nodiscard]] tl::expected<ProcessResult, std::string> run_process(
    sql::Connection& db, const repository::JobRecord& job, const service::IngestPlace& place,
    const core::Executor& executor, service::KeptWork& kept, const std::stop_token& stop,
    const core::ProgressCallback& progress, core::UtcTime now);

}  // namespace floeplan::jobs

#pragma once

#include <cstddef>
#include <stop_token>
#include <string>
#include <tl/expected.hpp>

#include "api/service/ingest_service.hpp"
#include "api/service/kept_work.hpp"
#include "engine/core/progress.hpp"
#include "engine/core/units.hpp"
#include "storage/repository/work/job_repository.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::jobs {

/// The result of a job.
struct ProcessResult {
  std::string json;       // the results document
  std::string message{};  // why it holds no route; empty: it holds what was asked for
};

/// Does the work of a job. Flights, departures and members are worked at on so many threads (`workers`) at once.
/// `kept`   of the store that `db` is connected to
/// Returns  of no use when `stop` was requested meanwhile
/// Errors   why it could not be done, for a person; std::exception when the machine or the stored data fail
[[nodiscard]] tl::expected<ProcessResult, std::string> run_process(
    sql::Connection& db, const repository::JobRecord& job, const service::IngestPlace& place,
    std::size_t workers, service::KeptWork& kept, const std::stop_token& stop,
    const core::ProgressCallback& progress, core::UtcTime now);

}  // namespace floeplan::jobs

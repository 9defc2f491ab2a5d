#pragma once

#include <nlohmann/json_fwd.hpp>
#include <stop_token>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "api/codec/inputs/ingest_inputs.hpp"
#include "engine/core/progress.hpp"
#include "storage/ingest/process/guarded_ingest.hpp"

namespace floeplan::service {

/// Where uploads are, and how files from outside are kept away from this process.
struct IngestPlace {
  ingest::Guard guard;
  std::filesystem::path uploads;  // folder of an UploadRepository
};

/// "stored", "refused" or "unchanged".
[[nodiscard]] std::string status_name(ingest::IngestStatus status);

/// The result for one kind of data in a file, for API, command line and watched folder.
[[nodiscard]] nlohmann::json report_document(const ingest::IngestReport& report);
/// {"datasets": [...]} with all reports.
[[nodiscard]] nlohmann::json report_document(const std::vector<ingest::IngestReport>& reports);

/// Logs the technical cause of a refusal, if the report has one.
void log_technical_cause(const ingest::IngestReport& report);

/// Reads uploads into the store for their `owner`. A refused file is part of the report, not an error.
/// `again`  true after an interrupted attempt: data reported as unchanged may then be the owner's from that
///          attempt
/// Errors   why nothing could be read: an upload has expired
[[nodiscard]] tl::expected<nlohmann::json, std::string> ingest_document(
    sql::Connection& db, const codec::IngestInputs& inputs, const IngestPlace& place,
    const std::string& owner, bool again, const std::stop_token& stop, const core::ProgressCallback& progress,
    core::UtcTime now);

}  // namespace floeplan::service

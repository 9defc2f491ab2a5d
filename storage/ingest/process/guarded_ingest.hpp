#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

#include "engine/core/progress.hpp"
#include "storage/ingest/common/ingest_options.hpp"
#include "storage/ingest/ingest_report.hpp"
#include "storage/ingest/process/guard.hpp"
#include "storage/sandbox/confinement.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::ingest {

/// What confines the processes that read files, as one of them tells; empty: it told nothing.
/// Errors   std::runtime_error when it cannot be started
[[nodiscard]] std::optional<sandbox::Layers> layers_in_force(const Guard& guard);

/// Reads several files as ingest_files does, but opens none of them itself: a child process that is confined and bounded
/// reads each group of files into a store of its own, and hands over the rows as plain values; what has arrived whole is
/// taken over in one transaction. A file that breaks its reader, or takes more time or memory than a file of its size
/// may, is refused and costs nothing else. Every file is refused where the machine cannot confine its reader.
/// `reported`  called with each report as soon as it is known; may be empty
/// Returns  the reports; of a group during which `stop` was requested none, and none of those after it
/// Errors   std::runtime_error when the store or the machine fails
[[nodiscard]] std::vector<IngestReport> guarded_ingest(
    sql::Connection& db, const Guard& guard, const std::vector<std::filesystem::path>& files,
    const IngestOptions& options, core::UtcTime now, const std::stop_token& stop,
    const core::ProgressCallback& progress, const std::function<void(const IngestReport&)>& reported);

}  // namespace floeplan::ingest

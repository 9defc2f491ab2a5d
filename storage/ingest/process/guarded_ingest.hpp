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

/// The sandbox layers that confine processes which read files, as reported by such a process; empty: it
/// reported nothing.
/// Errors   std::runtime_error when the process cannot be started
[[nodiscard]] std::optional<sandbox::Layers> layers_in_force(const Guard& guard);

/// Reads several files as ingest_files does, but opens none of them in this process. A confined child process
/// with limits reads each group of files into a store of its own and hands over the rows as plain values; a
/// complete group is stored in one transaction. A file that crashes its reader, or needs more time or memory
/// than its size allows, is refused without effect on others. Every file is refused if the machine cannot
/// confine its reader.
/// `reported`  called with each report as soon as it is known; may be empty
/// Returns  the reports; none for a group during which `stop` was requested, nor for later groups
/// Errors   std::runtime_error when the store or the machine fails
[[nodiscard]] std::vector<IngestReport> guarded_ingest(
    sql::Connection& db, const Guard& guard, const std::vector<std::filesystem::path>& files,
    const IngestOptions& options, core::UtcTime now, const std::stop_token& stop,
    const core::ProgressCallback& progress, const std::function<void(const IngestReport&)>& reported);

}  // namespace floeplan::ingest

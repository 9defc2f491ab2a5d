#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "engine/core/progress.hpp"
#include "engine/core/units.hpp"
#include "storage/ingest/common/ingest_options.hpp"
#include "storage/ingest/files/file_group.hpp"
#include "storage/ingest/ingest_report.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::ingest {

/// Reads a file into the store: recognises it by content, checks it, normalises it (WGS84, UTC, SI, depth
/// positive down, currents towards true east and north) and stores it in one transaction, or stores nothing
/// and says why. A file whose content is already stored as the same kind is reported as "unchanged". If an
/// earlier version of the program read it wrongly, it is read again and replaces the stored data. A file read
/// with other options (`identity_of`) makes another dataset.
/// Errors   std::runtime_error only when the store itself fails
[[nodiscard]] std::vector<IngestReport> ingest_file(sql::Connection& db, const std::filesystem::path& file,
                                                    const IngestOptions& options, core::UtcTime now,
                                                    const core::ProgressCallback& progress);

/// Does what ingest_file does, for several files that make one dataset.
/// Errors   as ingest_file
[[nodiscard]] std::vector<IngestReport> ingest_group(sql::Connection& db, const FileGroup& files,
                                                     const IngestOptions& options, core::UtcTime now,
                                                     const core::ProgressCallback& progress);

/// The report for files that were refused. The folder of the files is removed from the texts of the faults.
[[nodiscard]] IngestReport refused(const FileGroup& files, const IngestOptions& options, Messages faults);

/// Reads several files. Files that belong together make one dataset (as the two components of a current in
/// two files and a model's positions in a third); their content tells. Every other file makes a dataset of
/// its own.
/// `reported`  called with each report as soon as it is known; may be empty
/// Errors   as ingest_file
[[nodiscard]] std::vector<IngestReport> ingest_files(
    sql::Connection& db, const std::vector<std::filesystem::path>& files, const IngestOptions& options,
    core::UtcTime now, const core::ProgressCallback& progress,
    const std::function<void(const IngestReport&)>& reported);

}  // namespace floeplan::ingest

#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/progress.hpp"
#include "engine/core/units.hpp"
#include "engine/geo/lon_lat.hpp"
#include "storage/ingest/file_groups.hpp"
#include "storage/repository/dataset.hpp"
#include "storage/sqlite/connection.hpp"

namespace floeplan::ingest {

/// What the user said about a file beyond the file itself.
struct IngestOptions {
  std::optional<std::string> name{};              // default: the file's name without its ending
  std::optional<repository::DatasetKind> kind{};  // default: recognised
  std::optional<std::string> crs{};               // "EPSG:4326", for files that state none
  std::optional<std::string> positive{};          // "up" or "down", for bathymetry that does not say
  std::optional<geo::LonLat> at{};         // of a station of the tide whose file does not say where it is
  std::optional<std::string> unit{};       // "m" or "ft", of its amplitudes where the file does not say it
  std::optional<std::string> zone_kind{};  // "no_go" or "stay_in", for zones that do not say
  std::optional<std::string> variable{};   // of several pairs of currents or concentrations the one to use
  std::optional<double> missing{};         // what marks missing values in NetCDF that does not declare it
  std::optional<core::UtcTime> time{};     // for which sea ice holds that does not say it
  std::optional<std::string> archive{};    // name of the one that the files were unpacked from
};

enum class IngestStatus { stored, refused, unchanged };

/// What became of one kind of data in a file. A refused file stores nothing.
struct IngestReport {
  std::string file;  // "u.nc + v.nc" of files that were read together
  IngestStatus status{IngestStatus::refused};
  std::optional<repository::Dataset> dataset;  // empty when refused
  std::vector<std::string> warnings;
  std::vector<std::string> errors;  // each: what; why; what to do
  FileGroup files{};                // what `file` names; set by guarded_ingest
};

/// Reads a file into the store: recognises it by content, checks it, normalises it (WGS84, UTC, SI, depth positive
/// down, currents towards true east and north) and stores it in one transaction, or stores nothing and says why.
/// A file whose content is already stored under the same kind is "unchanged", unless an earlier program misread it: then
/// it is read again and replaces what was stored.
/// Errors   std::runtime_error only when the store itself fails
[[nodiscard]] std::vector<IngestReport> ingest_file(sqlite::Connection& db, const std::filesystem::path& file,
                                                    const IngestOptions& options, core::UtcTime now,
                                                    const core::ProgressCallback& progress);

/// As ingest_file, of files that make one dataset.
/// Errors   as ingest_file
[[nodiscard]] std::vector<IngestReport> ingest_group(sqlite::Connection& db, const FileGroup& files,
                                                     const IngestOptions& options, core::UtcTime now,
                                                     const core::ProgressCallback& progress);

/// The report of files of which nothing is stored. `reason`: sentences, one a line; where the files lie is taken out.
[[nodiscard]] IngestReport refused(const FileGroup& files, const IngestOptions& options, std::string reason);

/// Reads several files. Those that belong together make one dataset (the two components of a current in two files,
/// tables of a model's positions in a third), told by their content; every other file makes its own.
/// `reported`  called with each report as soon as it is known; may be empty
/// Errors   as ingest_file
[[nodiscard]] std::vector<IngestReport> ingest_files(
    sqlite::Connection& db, const std::vector<std::filesystem::path>& files, const IngestOptions& options,
    core::UtcTime now, const core::ProgressCallback& progress,
    const std::function<void(const IngestReport&)>& reported);

}  // namespace floeplan::ingest

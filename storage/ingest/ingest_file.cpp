#include "storage/ingest/ingest_file.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "storage/ingest/bathymetry_netcdf_reader.hpp"
#include "storage/ingest/bathymetry_raster_reader.hpp"
#include "storage/ingest/coastline_geojson_reader.hpp"
#include "storage/ingest/current_reader.hpp"
#include "storage/ingest/file_digest.hpp"
#include "storage/ingest/gdal_guard.hpp"
#include "storage/ingest/gshhg_coastline.hpp"
#include "storage/ingest/ice_reader.hpp"
#include "storage/ingest/iceberg_csv_reader.hpp"
#include "storage/ingest/iceberg_geojson_reader.hpp"
#include "storage/ingest/recognise.hpp"
#include "storage/repository/dataset_repository.hpp"
#include "storage/sqlite/transaction.hpp"

namespace floeplan::ingest {
namespace {

using repository::Dataset;
using repository::DatasetKind;

Checked<PreparedDataset> prepare(const RecognisedFile& file, DatasetKind kind, const IngestOptions& options,
                                 const core::ProgressCallback& progress) {
  switch (file.format) {
    case FileFormat::netcdf_classic:
    case FileFormat::netcdf4:
      if (kind == DatasetKind::coastline) return read_gshhg_coastline(file.path, progress);
      if (kind == DatasetKind::ice) return read_ice(file.netcdf, options, progress);
      return kind == DatasetKind::currents ? read_currents(file.netcdf, progress)
                                           : read_netcdf_bathymetry(*file.netcdf, options);
    case FileFormat::bag: return read_raster_bathymetry(file.path, "BAG", options);
    case FileFormat::geotiff: return read_raster_bathymetry(file.path, "GTiff", options);
    case FileFormat::ascii_grid: return read_raster_bathymetry(file.path, "AAIGrid", options);
    case FileFormat::xyz: return read_raster_bathymetry(file.path, "XYZ", options);
    case FileFormat::ice_patrol_csv: return read_ice_patrol_csv(file.path);
    case FileFormat::geojson:
      return kind == DatasetKind::icebergs ? read_geojson_icebergs(*file.geojson)
                                           : read_geojson_coastline(*file.geojson);
  }
  throw std::logic_error{"a file format without a reader"};
}

repository::DatasetId id_of(DatasetKind kind, const std::string& sha256) {
  return {repository::kind_name(kind) + "-" + sha256.substr(0, 8)};
}

Dataset dataset_of(const PreparedDataset& data, const std::filesystem::path& file,
                   const IngestOptions& options, const std::string& sha256, core::UtcTime now) {
  return {.id = id_of(data.kind, sha256),
          .kind = data.kind,
          .name = options.name.value_or(file.stem().string()),
          .variables = data.variables,
          .bounds = data.bounds,
          .time_start = data.time_start,
          .time_end = data.time_end,
          .rows_accepted = data.rows_accepted,
          .rows_refused = data.rows_refused,
          .warnings = data.warnings,
          .provenance = {.file_name = file.filename().string(),
                         .file_size_bytes = static_cast<std::int64_t>(std::filesystem::file_size(file)),
                         .sha256 = sha256,
                         .ingested = now,
                         .tool_version = "floeplan " FLOEPLAN_VERSION ", " + gdal_version()}};
}

/// GDAL quotes the whole path; where the file lies on this machine is not for everybody who reads the report.
std::string without_folder(std::string reason, const std::filesystem::path& file) {
  const std::string path = std::filesystem::absolute(file).string();
  const std::string name = file.filename().string();
  for (std::size_t at = reason.find(path); at != std::string::npos; at = reason.find(path, at + name.size()))
    reason.replace(at, path.size(), name);
  return reason;
}

IngestReport refused(const std::filesystem::path& file, std::string reason) {
  IngestReport report;
  report.file = file.filename().string();
  report.errors.push_back(without_folder(std::move(reason), file));
  return report;
}

/// One kind of data of the file on its way into the store.
struct Candidate {
  IngestReport report;
  std::optional<PreparedDataset> data;  // empty: refused or already there
};

/// Reads and checks one kind of data. Nothing is written yet: the store stays open for others meanwhile.
Candidate check_kind(sqlite::Connection& db, const RecognisedFile& file, DatasetKind kind,
                     const std::string& sha256, const IngestOptions& options,
                     const core::ProgressCallback& progress) {
  if (auto stored = repository::DatasetRepository{db}.find(id_of(kind, sha256))) {
    if (stored->provenance.sha256 != sha256)
      return {refused(file.path,
                      "another dataset already has the id " + stored->id.value +
                          "; two files share the first digits of their checksum; remove the other one first"),
              std::nullopt};
    return {{.file = file.path.filename().string(),
             .status = IngestStatus::unchanged,
             .dataset = std::move(stored),
             .warnings = {},
             .errors = {}},
            std::nullopt};
  }
  auto data = prepare(file, kind, options, progress);
  if (!data) return {refused(file.path, data.error()), std::nullopt};
  return {{}, std::move(*data)};
}

/// Stores what was checked. Runs inside the file's transaction.
IngestReport store(sqlite::Connection& db, const RecognisedFile& file, const PreparedDataset& data,
                   Dataset dataset) {
  repository::DatasetRepository{db}.insert(dataset);
  const auto written = data.write(db, dataset.id);
  if (!written) return refused(file.path, written.error());
  return {.file = file.path.filename().string(),
          .status = IngestStatus::stored,
          .dataset = std::move(dataset),
          .warnings = data.warnings,
          .errors = {}};
}

/// Says of everything that was good why it was not stored all the same.
void refuse_the_rest(std::vector<Candidate>& candidates, const std::filesystem::path& file) {
  for (Candidate& candidate : candidates) {
    if (!candidate.data || !candidate.report.errors.empty()) continue;
    const std::string kind = repository::kind_name(candidate.data->kind);
    candidate.report = refused(file, "the file also holds " + kind +
                                         ", which were not stored because its other data were refused; a "
                                         "file is stored whole or not at all; give --kind " +
                                         kind + " to store this part alone");
  }
}

}  // namespace

std::vector<IngestReport> ingest_file(sqlite::Connection& db, const std::filesystem::path& file,
                                      const IngestOptions& options, core::UtcTime now,
                                      const core::ProgressCallback& progress) {
  const GdalMessages quiet;
  const auto recognised = recognise(file, options.kind);
  if (!recognised) return {refused(file, recognised.error())};
  const auto sha256 = sha256_of_file(file);
  if (!sha256) return {refused(file, sha256.error())};

  std::vector<Candidate> candidates;
  for (const DatasetKind kind : recognised->kinds)
    candidates.push_back(check_kind(db, *recognised, kind, *sha256, options, progress));

  const auto failed = [](const Candidate& candidate) { return !candidate.report.errors.empty(); };
  if (std::none_of(candidates.begin(), candidates.end(), failed)) {
    sqlite::Transaction transaction{db};
    for (Candidate& candidate : candidates)
      if (candidate.data)
        candidate.report =
            store(db, *recognised, *candidate.data, dataset_of(*candidate.data, file, options, *sha256, now));
    if (std::none_of(candidates.begin(), candidates.end(), failed)) transaction.commit();
  }
  if (std::any_of(candidates.begin(), candidates.end(), failed)) refuse_the_rest(candidates, file);

  std::vector<IngestReport> reports;
  for (Candidate& candidate : candidates) reports.push_back(std::move(candidate.report));
  return reports;
}

}  // namespace floeplan::ingest

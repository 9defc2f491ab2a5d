#include "storage/ingest/ingest_file.hpp"

#include <algorithm>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "engine/core/version.hpp"
#include "storage/ingest/common/gdal_guard.hpp"
#include "storage/ingest/file_groups.hpp"
#include "storage/ingest/files/file_digest.hpp"
#include "storage/ingest/files/sidecar.hpp"
#include "storage/ingest/formats/netcdf/model_run.hpp"
#include "storage/ingest/formats/slocum/slocum_header.hpp"
#include "storage/ingest/formats/vector/vector_file.hpp"
#include "storage/ingest/formats/zarr/zarr_store.hpp"
#include "storage/ingest/open_end.hpp"
#include "storage/ingest/readers/bathymetry/bathymetry_netcdf_reader.hpp"
#include "storage/ingest/readers/bathymetry/bathymetry_raster_reader.hpp"
#include "storage/ingest/readers/bathymetry/s57_cell.hpp"
#include "storage/ingest/readers/bathymetry/s57_reader.hpp"
#include "storage/ingest/readers/coastline/coastline_reader.hpp"
#include "storage/ingest/readers/coastline/gshhg_coastline.hpp"
#include "storage/ingest/readers/currents/current_reader.hpp"
#include "storage/ingest/readers/currents/grib_currents.hpp"
#include "storage/ingest/readers/currents/wind_reader.hpp"
#include "storage/ingest/readers/ice/ice_chart_reader.hpp"
#include "storage/ingest/readers/ice/ice_reader.hpp"
#include "storage/ingest/readers/ice/ice_variables.hpp"
#include "storage/ingest/readers/icebergs/iceberg_csv_reader.hpp"
#include "storage/ingest/readers/icebergs/iceberg_geojson_reader.hpp"
#include "storage/ingest/readers/icebergs/iceberg_own_table.hpp"
#include "storage/ingest/readers/icebergs/iceberg_table_reader.hpp"
#include "storage/ingest/readers/tides/tide_reader.hpp"
#include "storage/ingest/readers/tides/tide_table.hpp"
#include "storage/ingest/readers/tracks/glider_netcdf.hpp"
#include "storage/ingest/readers/tracks/slocum_reader.hpp"
#include "storage/ingest/readers/zones/zone_reader.hpp"
#include "storage/ingest/recognise.hpp"
#include "storage/repository/dataset_repository.hpp"
#include "storage/sqlite/transaction.hpp"

namespace floeplan::ingest {
namespace {

using repository::Dataset;
using repository::DatasetKind;

/// A file and what was given to be read together with it.
NetcdfFiles together(const RecognisedFile& file) {
  NetcdfFiles files{file.netcdf};
  files.insert(files.end(), file.companions.begin(), file.companions.end());
  return files;
}

Checked<PreparedDataset> prepare_features(const RecognisedFile& file, DatasetKind kind,
                                          const IngestOptions& options) {
  if (kind == DatasetKind::icebergs) return read_geojson_icebergs(*file.features);
  if (kind == DatasetKind::coastline) return read_coastline(*file.features, options);
  if (kind == DatasetKind::ice) return read_ice_polygons(*file.features, file.path, options);
  return read_zones(*file.features, options);
}

Checked<PreparedDataset> prepare(const RecognisedFile& file, const FileGroup& files, DatasetKind kind,
                                 const IngestOptions& options, const core::ProgressCallback& progress) {
  switch (file.format) {
    case FileFormat::netcdf_classic:
    case FileFormat::netcdf4:
    case FileFormat::zarr:
      if (kind == DatasetKind::glider_tracks)
        return is_glider_track(*file.netcdf) ? read_glider_netcdf(files, progress)
                                             : read_slocum_tracks(files, progress);
      if (kind == DatasetKind::coastline) return read_gshhg_coastline(file.path, progress);
      if (kind == DatasetKind::tides) return read_tides(together(file), file.path, options, progress);
      if (kind == DatasetKind::wind) return read_wind(file.netcdf, options.crs, progress);
      if (kind == DatasetKind::ice) return read_ice(file.netcdf, options, progress);
      return kind == DatasetKind::currents
                 ? read_currents(together(file), options.crs, options.variable, progress)
                 : read_netcdf_bathymetry(file.netcdf, options);
    case FileFormat::grib:
      return kind == DatasetKind::wind ? read_grib_wind(file.path, progress)
                                       : read_grib_currents(file.path, progress);
    case FileFormat::s57: return read_s57_bathymetry(file.path);
    case FileFormat::bag: return read_raster_bathymetry(file.path, "BAG", options);
    case FileFormat::geotiff: return read_raster_bathymetry(file.path, "GTiff", options);
    case FileFormat::ascii_grid: return read_raster_bathymetry(file.path, "AAIGrid", options);
    case FileFormat::xyz: return read_raster_bathymetry(file.path, "XYZ", options);
    case FileFormat::depth_table: return read_depth_table(file.path, options);
    case FileFormat::tide_json: return read_tide_json(file.path, options);
    case FileFormat::tide_table: return read_tide_table(file.path, options);
    case FileFormat::otps_extract: return read_otps_extract(file.path);
    case FileFormat::iceberg_table: return read_iceberg_table(file.path);
    case FileFormat::own_iceberg_table: return read_own_iceberg_table(file.path);
    case FileFormat::iceberg_json: return read_iceberg_list_json(file.path);
    case FileFormat::ice_patrol_csv: return read_ice_patrol_csv(file.path);
    case FileFormat::slocum_text:
    case FileFormat::slocum_binary: return read_slocum_tracks(files, progress);
    case FileFormat::geojson:
    case FileFormat::kml:
    case FileFormat::geopackage:
    case FileFormat::shapefile: return prepare_features(file, kind, options);
  }
  throw std::logic_error{"a file format without a reader"};
}

repository::DatasetId id_of(DatasetKind kind, const std::string& sha256) {
  return {repository::kind_name(kind) + "-" + sha256.substr(0, 8)};
}

/// "u.nc + v.nc", "charts.zip: ice.shp"; of the many files of a track the first ones.
std::string names_of(const FileGroup& files, const IngestOptions& options) {
  constexpr std::size_t most_names = 8;
  std::string names;
  std::size_t count = 0;
  for (const std::filesystem::path& file : files) {
    if (is_sidecar_of(file, files.front()) || ++count > most_names) continue;
    names += (names.empty() ? "" : " + ") + file.filename().string();
  }
  if (count > most_names) names += " + " + std::to_string(count - most_names) + " files more";
  return options.archive ? *options.archive + ": " + names : names;
}

std::int64_t size_of(const FileGroup& files) {
  std::uintmax_t bytes = 0;
  for (const std::filesystem::path& file : files)
    bytes += std::filesystem::is_directory(file) ? bytes_of_zarr(file) : std::filesystem::file_size(file);
  return static_cast<std::int64_t>(bytes);
}

Dataset dataset_of(const PreparedDataset& data, const FileGroup& files, const IngestOptions& options,
                   const std::string& sha256, core::UtcTime now) {
  return {.id = id_of(data.kind, sha256),
          .kind = data.kind,
          .name = options.name.value_or(files.front().stem().string()),
          .variables = data.variables,
          .bounds = data.bounds,
          .time_start = data.time_start,
          .time_end = data.time_end,
          .run = data.run,
          .rows_accepted = data.rows_accepted,
          .rows_refused = data.rows_refused,
          .warnings = data.warnings,
          .provenance = {.file_name = names_of(files, options),
                         .file_size_bytes = size_of(files),
                         .sha256 = sha256,
                         .ingested = now,
                         .tool_version = std::string{core::program_version()} + ", " + gdal_version()}};
}

/// GDAL quotes the whole path; where the file lies on this machine is not for everybody who reads the report.
std::string without_folder(std::string reason, const std::filesystem::path& file) {
  const std::string path = std::filesystem::absolute(file).string();
  const std::string name = file.filename().string();
  for (std::size_t at = reason.find(path); at != std::string::npos; at = reason.find(path, at + name.size()))
    reason.replace(at, path.size(), name);
  return reason;
}

/// One kind of data of the file on its way into the store.
struct Candidate {
  IngestReport report;
  std::optional<PreparedDataset> data;  // empty: refused or already there
};

/// Sea ice and depths beside currents that are on a bent grid are not taken along: nobody should believe them stored.
void warn_of_what_is_left(const RecognisedFile& file, std::vector<std::string>& warnings) {
  const auto left = [&](DatasetKind kind, bool held, const std::string& what) {
    if (!held || std::ranges::find(file.kinds, kind) != file.kinds.end()) return;
    warnings.push_back("the file also holds " + what +
                       ", which were not stored with its currents; store them with --kind " +
                       repository::kind_name(kind) + " in a second command");
  };
  left(DatasetKind::ice, holds_ice(*file.netcdf), "concentrations of sea ice");
  left(DatasetKind::bathymetry, find_bathymetry(*file.netcdf, false) != nullptr, "depths of the sea bed");
}

/// Reads and checks one kind of data. Nothing is written yet: the store stays open for others meanwhile.
Candidate check_kind(sqlite::Connection& db, const RecognisedFile& file, const FileGroup& files,
                     DatasetKind kind, const std::string& sha256, const IngestOptions& options,
                     const core::ProgressCallback& progress) {
  if (auto stored = repository::DatasetRepository{db}.find(id_of(kind, sha256))) {
    if (stored->provenance.sha256 != sha256)
      return {refused(files, options,
                      "another dataset already has the id " + stored->id.value +
                          "; two files share the first digits of their checksum; remove the other one first"),
              std::nullopt};
    if (!stored->outdated)
      return {{.file = names_of(files, options),
               .status = IngestStatus::unchanged,
               .dataset = std::move(stored),
               .warnings = {},
               .errors = {}},
              std::nullopt};
  }
  auto data = prepare(file, files, kind, options, progress);
  if (!data) return {refused(files, options, data.error()), std::nullopt};
  if (file.netcdf && repository::has_steps(kind)) data->run = model_run_of(*file.netcdf);
  if (file.netcdf && kind == DatasetKind::currents && !options.kind)
    warn_of_what_is_left(file, data->warnings);
  data->warnings.insert(data->warnings.begin(), file.warnings.begin(), file.warnings.end());
  if (auto warning = warning_of_open_end(file.path, file.format))
    data->warnings.push_back(std::move(*warning));
  return {{}, std::move(*data)};
}

/// Stores what was checked, in place of what was misread of the same file. Runs inside the file's transaction.
IngestReport store(sqlite::Connection& db, const FileGroup& files, const IngestOptions& options,
                   const PreparedDataset& data, Dataset dataset) {
  repository::DatasetRepository datasets{db};
  if (const auto before = datasets.find(dataset.id); before && before->outdated) datasets.remove(dataset.id);
  datasets.insert(dataset);
  const auto written = data.write(db, dataset.id);
  if (!written) return refused(files, options, written.error());
  return {.file = dataset.provenance.file_name,
          .status = IngestStatus::stored,
          .dataset = std::move(dataset),
          .warnings = data.warnings,
          .errors = {}};
}

/// Says of everything that was good why it was not stored all the same.
void refuse_the_rest(std::vector<Candidate>& candidates, const FileGroup& files,
                     const IngestOptions& options) {
  for (Candidate& candidate : candidates) {
    if (!candidate.data || !candidate.report.errors.empty()) continue;
    const std::string kind = repository::kind_name(candidate.data->kind);
    candidate.report = refused(files, options,
                               "the file also holds " + kind +
                                   ", which were not stored because its other data were refused; a "
                                   "file is stored whole or not at all; give --kind " +
                                   kind + " to store this part alone");
  }
}

/// Opens the files that were given with the first one.
Checked<NetcdfFiles> open_companions(const FileGroup& files, const IngestOptions& options) {
  NetcdfFiles companions;
  for (std::size_t i = 1; i < files.size(); ++i) {
    auto file = NetcdfFile::open(files[i], options.missing);
    if (!file) return refuse(file.error());
    companions.push_back(std::make_shared<const NetcdfFile>(std::move(*file)));
  }
  return companions;
}

/// Of all the files that what was recognised consists of.
Checked<std::string> digest_of(const RecognisedFile& recognised, const FileGroup& files) {
  if (recognised.format == FileFormat::zarr) return sha256_of_zarr(files.front());
  if (recognised.format == FileFormat::shapefile) return sha256_of_files(parts_of_shapefile(files.front()));
  if (recognised.format == FileFormat::s57) return sha256_of_files(parts_of_s57(files.front()));
  if (recognised.format == FileFormat::slocum_binary) return sha256_of_files(without_sensor_caches(files));
  return sha256_of_files(files);
}

}  // namespace

IngestReport refused(const FileGroup& files, const IngestOptions& options, std::string reason) {
  IngestReport report;
  report.file = names_of(files, options);
  for (const std::filesystem::path& file : files) reason = without_folder(std::move(reason), file);
  std::istringstream lines{reason};
  for (std::string line; std::getline(lines, line);) report.errors.push_back(line);
  return report;
}

std::vector<IngestReport> ingest_group(sqlite::Connection& db, const FileGroup& files,
                                       const IngestOptions& options, core::UtcTime now,
                                       const core::ProgressCallback& progress) {
  const GdalMessages quiet;
  auto recognised = recognise(files.front(), {.kind = options.kind,
                                              .zone_kind_stated = options.zone_kind.has_value(),
                                              .variable = options.variable,
                                              .missing = options.missing});
  if (!recognised) return {refused(files, options, recognised.error())};
  const bool tracks = recognised->kinds.front() == DatasetKind::glider_tracks;
  if (recognised->netcdf && !tracks) {  // the parts of others are found beside them, or read one by one
    auto companions = open_companions(files, options);
    if (!companions) return {refused(files, options, companions.error())};
    recognised->companions = std::move(*companions);
  }
  const auto sha256 = digest_of(*recognised, files);
  if (!sha256) return {refused(files, options, sha256.error())};

  std::vector<Candidate> candidates;
  for (const DatasetKind kind : recognised->kinds)
    candidates.push_back(check_kind(db, *recognised, files, kind, *sha256, options, progress));

  const auto failed = [](const Candidate& candidate) { return !candidate.report.errors.empty(); };
  if (std::none_of(candidates.begin(), candidates.end(), failed)) {
    sqlite::Transaction transaction{db};
    for (Candidate& candidate : candidates)
      if (candidate.data)
        candidate.report = store(db, files, options, *candidate.data,
                                 dataset_of(*candidate.data, files, options, *sha256, now));
    if (std::none_of(candidates.begin(), candidates.end(), failed)) transaction.commit();
  }
  if (std::any_of(candidates.begin(), candidates.end(), failed)) refuse_the_rest(candidates, files, options);

  std::vector<IngestReport> reports;
  reports.reserve(candidates.size());
  for (Candidate& candidate : candidates) reports.push_back(std::move(candidate.report));
  return reports;
}

std::vector<IngestReport> ingest_file(sqlite::Connection& db, const std::filesystem::path& file,
                                      const IngestOptions& options, core::UtcTime now,
                                      const core::ProgressCallback& progress) {
  return ingest_group(db, {file}, options, now, progress);
}

std::vector<IngestReport> ingest_files(sqlite::Connection& db,
                                       const std::vector<std::filesystem::path>& files,
                                       const IngestOptions& options, core::UtcTime now,
                                       const core::ProgressCallback& progress,
                                       const std::function<void(const IngestReport&)>& reported) {
  std::vector<IngestReport> reports;
  for (const FileGroup& group : group_files(files)) {
    for (IngestReport& report : ingest_group(db, group, options, now, progress)) {
      if (reported) reported(report);
      reports.push_back(std::move(report));
    }
  }
  return reports;
}

}  // namespace floeplan::ingest

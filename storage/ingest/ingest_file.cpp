#include "storage/ingest/ingest_file.hpp"

#include <algorithm>
#include <fstream>
#include <optional>
#include <stdexcept>

#include "engine/core/shown_text.hpp"
#include "engine/core/version.hpp"
#include "engine/messages/ingest_file_messages.hpp"
#include "engine/messages/sentence.hpp"
#include "storage/ingest/common/gdal_guard.hpp"
#include "storage/ingest/dataset_identity.hpp"
#include "storage/ingest/file_groups.hpp"
#include "storage/ingest/files/file_digest.hpp"
#include "storage/ingest/files/sidecar.hpp"
#include "storage/ingest/formats/netcdf/model_run.hpp"
#include "storage/ingest/formats/zarr/zarr_store.hpp"
#include "storage/ingest/netcdf_contents.hpp"
#include "storage/ingest/recognise.hpp"
#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/repository/datasets/resampled.hpp"
#include "storage/sql/transaction.hpp"

namespace floeplan::ingest {
namespace {

using repository::Dataset;
using repository::DatasetKind;

/// "u.nc + v.nc", "charts.zip: ice.shp"; at most eight names, because a track can have hundreds of files.
std::string names_of(const FileGroup& files, const IngestOptions& options) {
  constexpr std::size_t most_names = 8;
  std::string names;
  std::size_t count = 0;
  for (const std::filesystem::path& file : files) {
    if (is_sidecar_of(file, files.front()) || ++count > most_names) continue;
    names += (names.empty() ? "" : " + ") + file.filename().string();
  }
  if (count > most_names) names += " + " + core::counted(count - most_names, "file") + " more";
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
  return {.id = id_of(data.kind, identity_of(sha256, data.kind, options), data.keeping),
          .kind = data.kind,
          .name = options.name.value_or(files.front().stem().string()),
          .variables = data.variables,
          .bounds = data.bounds,
          .time_start = data.time_start,
          .time_end = data.time_end,
          .run = data.run,
          .rows_accepted = data.rows_accepted,
          .rows_refused = data.rows_refused,
          .warnings = messages::sentences(data.warnings),
          .provenance = {.file_name = names_of(files, options),
                         .file_size_bytes = size_of(files),
                         .sha256 = sha256,
                         .ingested = now,
                         .tool_version = std::string{core::program_version()} + ", " + gdal_version()}};
}

void replace_all(std::string& text, const std::string& part, const std::string& by) {
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + by.size()))
    text.replace(at, part.size(), by);
}

/// Removes the folder from a text: GDAL quotes whole paths, and not every reader of the report may see them.
void leave_out_folder(messages::Message& fault, const std::filesystem::path& file) {
  const std::string path = std::filesystem::absolute(file).string();
  const std::string name = file.filename().string();
  replace_all(fault.text, path, name);
  replace_all(fault.hint, path, name);
  for (messages::NamedValue& value : fault.values)
    if (auto* words = std::get_if<std::string>(&value.value)) replace_all(*words, path, name);
}

/// One kind of data in a file, before it is stored.
struct Candidate {
  IngestReport report;
  std::optional<PreparedDataset> data;  // empty: refused or already there
};

bool ends_with_a_line(const std::filesystem::path& file) {
  std::ifstream in{file, std::ios::binary | std::ios::ate};
  if (!in || in.tellg() <= 0) return true;
  in.seekg(-1, std::ios::end);
  const int last = in.get();
  return last == '\n' || last == '\r';
}

/// Warns of a table whose last line has no line end. The file may be complete, or cut off within its last
/// number. The number is then wrong, but still valid.
void warn_of_open_end(const RecognisedFile& file, Messages& warnings) {
  if (file.format->has_lines && !ends_with_a_line(file.path))
    warnings.push_back(messages::ingest_file_message<"last-line-without-end">());
}

/// Warns of a stored dataset that was read from the same file with other options. Both stay in the store,
/// because only the user knows which is right.
void warn_of_other_reading(sql::Connection& db, DatasetKind kind, const std::string& sha256,
                           Messages& warnings) {
  const auto stored = repository::DatasetRepository{db}.list();
  const auto other = std::ranges::find_if(stored, [&](const Dataset& dataset) {
    return dataset.kind == kind && dataset.provenance.sha256 == sha256 && !dataset.outdated &&
           !repository::was_resampled(dataset.warnings);
  });
  if (other != stored.end())
    warnings.push_back(messages::ingest_file_message<"file-read-otherwise-before">(other->id.value));
}

/// Reads and checks one kind of data. Writes nothing yet, so other connections can use the store meanwhile.
Candidate check_kind(sql::Connection& db, const RecognisedFile& file, const FileGroup& files,
                     DatasetKind kind, const std::string& sha256, const IngestOptions& options,
                     const core::ProgressCallback& progress) {
  const std::string identity = identity_of(sha256, kind, options);
  for (const Keeping keeping : {Keeping::on_a_projected_grid, Keeping::at_points_of_components,
                                Keeping::at_own_points, Keeping::on_a_grid}) {
    auto stored = repository::DatasetRepository{db}.find(id_of(kind, identity, keeping));
    if (!stored) continue;
    if (stored->provenance.sha256 != sha256)
      return {refused(files, options, {messages::ingest_file_message<"dataset-id-taken">(stored->id.value)}),
              std::nullopt};
    if (!stored->outdated && !repository::was_resampled(stored->warnings))
      return {{.file = names_of(files, options),
               .status = IngestStatus::unchanged,
               .dataset = std::move(stored),
               .warnings = {},
               .errors = {}},
              std::nullopt};
  }
  auto data = file.format->read({file, files, kind, options, progress});
  if (!data) return {refused(files, options, data.error()), std::nullopt};
  if (file.netcdf && repository::has_steps(kind)) data->run = model_run_of(*file.netcdf);
  if (file.netcdf && kind == DatasetKind::currents && !options.kind)
    warn_of_what_is_left(file, data->warnings);
  data->warnings.insert(data->warnings.begin(), file.warnings.begin(), file.warnings.end());
  warn_of_open_end(file, data->warnings);
  warn_of_other_reading(db, kind, sha256, data->warnings);
  return {{}, std::move(*data)};
}

/// Stores checked data. Replaces what an older program read wrongly from the same file. Runs inside the
/// file's transaction.
IngestReport store(sql::Connection& db, const FileGroup& files, const IngestOptions& options,
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

/// Refuses the valid kinds of a file because another kind of it was refused; the report of each says so.
void refuse_the_rest(std::vector<Candidate>& candidates, const FileGroup& files,
                     const IngestOptions& options) {
  for (Candidate& candidate : candidates) {
    if (!candidate.data || !candidate.report.errors.empty()) continue;
    const std::string kind = repository::kind_name(candidate.data->kind);
    candidate.report = refused(files, options, {messages::ingest_file_message<"kind-not-stored">(kind)});
  }
}

/// Opens the further files of the group.
Checked<NetcdfFiles> open_companions(const FileGroup& files, const IngestOptions& options) {
  NetcdfFiles companions;
  for (std::size_t i = 1; i < files.size(); ++i) {
    auto file = NetcdfFile::open(files[i], options.missing);
    if (!file) return refuse(file.error());
    companions.push_back(std::make_shared<const NetcdfFile>(std::move(*file)));
  }
  return companions;
}

/// Digest of all files that the recognised data come from.
Checked<std::string> digest_of(const RecognisedFile& recognised, const FileGroup& files) {
  if (recognised.format->digest != nullptr) return recognised.format->digest(files);
  return sha256_of_files(files);
}

}  // namespace

IngestReport refused(const FileGroup& files, const IngestOptions& options, Messages faults) {
  IngestReport report;
  report.file = names_of(files, options);
  report.errors = std::move(faults);
  for (const std::filesystem::path& file : files)
    for (messages::Message& fault : report.errors) leave_out_folder(fault, file);
  return report;
}

std::vector<IngestReport> ingest_group(sql::Connection& db, const FileGroup& files,
                                       const IngestOptions& options, core::UtcTime now,
                                       const core::ProgressCallback& progress) {
  const GdalMessages quiet;
  auto recognised = recognise(files.front(), {.kind = options.kind,
                                              .zone_kind_stated = options.zone_kind.has_value(),
                                              .variable = options.variable,
                                              .missing = options.missing});
  if (!recognised) return {refused(files, options, recognised.error())};
  const bool tracks = recognised->kinds.front() == DatasetKind::glider_tracks;
  // other groups find their parts beside the file, or read them one by one
  if (recognised->netcdf && !tracks) {
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
    sql::Transaction transaction{db};
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

std::vector<IngestReport> ingest_file(sql::Connection& db, const std::filesystem::path& file,
                                      const IngestOptions& options, core::UtcTime now,
                                      const core::ProgressCallback& progress) {
  return ingest_group(db, {file}, options, now, progress);
}

std::vector<IngestReport> ingest_files(sql::Connection& db, const std::vector<std::filesystem::path>& files,
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

#include "api/service/ingest_service.hpp"

#include <stdexcept>

#include "api/codec/bytes/document_values.hpp"
#include "api/codec/documents/dataset_document.hpp"
#include "api/log/log.hpp"
#include "engine/messages/sentence.hpp"
#include "storage/ingest/files/file_digest.hpp"
#include "storage/ingest/process/staging_folder.hpp"
#include "storage/json/json.hpp"
#include "storage/repository/access/owners.hpp"
#include "storage/repository/work/uploads_of.hpp"

namespace floeplan::service {
namespace {

using nlohmann::json;

ingest::IngestOptions options_of(const codec::IngestInputs& inputs) {
  ingest::IngestOptions options;
  options.name = inputs.name;
  options.kind = inputs.kind;
  options.crs = inputs.crs;
  options.positive = inputs.positive;
  options.at = inputs.at;
  options.unit = inputs.unit;
  options.zone_kind = inputs.zone_kind;
  options.variable = inputs.variable;
  options.missing = inputs.missing;
  options.time = inputs.time;
  return options;
}

/// Puts the uploads under their original names into one folder, because parts of a dataset are found by their
/// names.
tl::expected<std::vector<std::filesystem::path>, std::string> lay_out(const codec::IngestInputs& inputs,
                                                                      const repository::UploadRepository& stored,
                                                                      const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const std::string& id : inputs.uploads) {
    const auto upload = stored.find(id);
    if (!upload)
      return tl::unexpected("the upload " + id + " was removed or has expired; send the file again");
    const std::filesystem::path file = folder / upload->name;
    if (const std::error_code error = stored.lay_out(*upload, file))
      return tl::unexpected("the upload " + upload->name + " cannot be read: " + error.message());
    const auto digest = ingest::sha256_of_file(file);
    if (!digest || *digest != upload->sha256)
      return tl::unexpected(
          "the upload " + upload->name +
          " is no longer as it arrived: the server's disk has changed it; send the file again, "
          "and have the server's operator look at the disk");
    files.push_back(file);
  }
  return files;
}

}  // namespace

std::string status_name(ingest::IngestStatus status) {
  switch (status) {
    case ingest::IngestStatus::stored: return "stored";
    case ingest::IngestStatus::refused: return "refused";
    case ingest::IngestStatus::unchanged: return "unchanged";
  }
  throw std::logic_error{"IngestStatus without a name"};
}

json report_document(const ingest::IngestReport& report) {
  json document = report.dataset
                      ? codec::dataset_document(*report.dataset)
                      : json{{"kind", nullptr},    {"name", nullptr},       {"variables", json::array()},
                             {"bbox", nullptr},    {"time_start", nullptr}, {"time_end", nullptr},
                             {"rows_accepted", 0}, {"rows_refused", 0}};
  document["dataset_id"] = report.dataset ? json(report.dataset->id.value) : json(nullptr);
  document["file"] = report.file;
  document["status"] = status_name(report.status);
  document["warnings"] = messages::sentences(report.warnings);
  document["errors"] = messages::sentences(report.errors);
  ingest::Messages all = report.errors;
  all.insert(all.end(), report.warnings.begin(), report.warnings.end());
  document["messages"] = codec::messages_json(messages::by_rank(std::move(all)));
  return document;
}

json report_document(const std::vector<ingest::IngestReport>& reports) {
  json documents = json::array();
  for (const auto& report : reports) documents.push_back(report_document(report));
  return {{"datasets", std::move(documents)}};
}

void log_technical_cause(const ingest::IngestReport& report) {
  if (report.technical_cause.empty()) return;
  log::warn({"reader failed file=\"", report.file, "\" cause=\"", report.technical_cause, "\""});
}

tl::expected<json, std::string> ingest_document(sql::Connection& db, const codec::IngestInputs& inputs,
                                                const IngestPlace& place, const std::string& owner,
                                                bool again, const std::stop_token& stop,
                                                const core::ProgressCallback& progress, core::UtcTime now) {
  const ingest::StagingFolder folder{place.guard.staging};
  const auto files = lay_out(inputs, *repository::uploads_of(db, place.uploads), folder.path());
  if (!files) return tl::unexpected(files.error());
  const auto take_note = [&](const ingest::IngestReport& report) {
    log_technical_cause(report);
    const bool is_new = report.status == ingest::IngestStatus::stored;
    if (report.dataset && (is_new || again))
      repository::Owners{db}.note_dataset(report.dataset->id.value, owner);
  };
  return report_document(
      ingest::guarded_ingest(db, place.guard, *files, options_of(inputs), now, stop, progress, take_note));
}

}  // namespace floeplan::service

#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/progress.hpp"
#include "storage/ingest/process/guard.hpp"
#include "storage/ingest/process/reader_messages.hpp"

namespace floeplan::ingest {

/// Everything that a child process reported before it ended.
struct Told {
  std::vector<IngestReport> reports;
  std::optional<Grouped> grouped;
  std::optional<UnpackedArchive> unpacked;
  std::size_t looks_at{};
  std::optional<sandbox::Layers> layers;       // layers that confined it
  std::optional<messages::Message> breakdown;  // why the files are refused; empty if the process did its work
  std::string technical_cause;                 // cause of the breakdown, as in IngestReport
  bool stopped{false};
};

/// Starts a process that carries out a request for some files, within the limits for their size, and listens
/// to it until it has finished, has died or was stopped. Files that the process wrote to `staging` must not
/// be trusted.
/// `rows`   called with each parcel of rows (repository::send_datasets); if it throws
///          repository::BrokenParcel, this counts as a breakdown of the process
/// Errors   std::runtime_error when the store or the machine fails
[[nodiscard]] Told run_reader(const Guard& guard, const std::filesystem::path& staging,
                              const FileGroup& files, ReaderRequest request, const std::stop_token& stop,
                              const core::ProgressCallback& progress,
                              const std::function<void(std::string_view)>& rows);

/// The message for files whose process ended without any report.
[[nodiscard]] messages::Message unexplained_end();

}  // namespace floeplan::ingest

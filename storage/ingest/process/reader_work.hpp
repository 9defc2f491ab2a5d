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

/// Everything a child process told until its end.
struct Told {
  std::vector<IngestReport> reports;
  std::optional<Grouped> grouped;
  std::optional<UnpackedArchive> unpacked;
  std::size_t looks_at{};
  std::optional<sandbox::Layers> layers;  // that it was confined by
  std::optional<messages::Message>
      breakdown;                // why the files are refused; empty where the process did its work
  std::string technical_cause;  // of the breakdown, as IngestReport has it
  bool stopped{false};
};

/// Starts a process that does with the files what the request says, within the limits for files of their size, and
/// listens to it until it has finished, died or was stopped. Nothing that it wrote to `staging` is to be believed.
/// `rows`   called with each parcel of rows (repository::send_datasets); repository::BrokenParcel from it breaks the
///          process down
/// Errors   std::runtime_error when the store or the machine fails
[[nodiscard]] Told run_reader(const Guard& guard, const std::filesystem::path& staging,
                              const FileGroup& files, ReaderRequest request, const std::stop_token& stop,
                              const core::ProgressCallback& progress,
                              const std::function<void(std::string_view)>& rows);

/// What is said of files whose process ended without a word.
[[nodiscard]] messages::Message unexplained_end();

}  // namespace floeplan::ingest

#include "storage/ingest/guarded_ingest.hpp"

#include <sys/wait.h>

#include <algorithm>
#include <csignal>
#include <cstring>
#include <fstream>
#include <optional>
#include <set>
#include <stdexcept>

#include "storage/ingest/reader_main.hpp"
#include "storage/ingest/reader_messages.hpp"
#include "storage/ingest/reader_process.hpp"
#include "storage/ingest/staging_folder.hpp"
#include "storage/repository/dataset_repository.hpp"
#include "storage/repository/dataset_transfer.hpp"
#include "storage/repository/migrations.hpp"

namespace floeplan::ingest {
namespace {

/// Everything a child process told until its end.
struct Told {
  std::vector<IngestReport> reports;
  std::optional<Grouped> grouped;
  std::size_t looks_at{};
  std::string breakdown;  // why the files are refused; empty when the process did its work
  bool stopped{false};
};

std::string too_long(std::uint64_t seconds) {
  return "reading took more than " + std::to_string(seconds) +
         " s, far longer than a file of this size needs; it is damaged or unpacks to much more than it "
         "seems; "
         "copy it again, or cut out your area and period";
}

std::string too_large(std::uint64_t bytes) {
  return "reading needs more than " + std::to_string(bytes / 1'000'000) +
         " MB of memory; the file is damaged or unpacks to much more than it seems; copy it again, or cut "
         "out "
         "your area and period";
}

/// Why a process ended before its work was done.
std::string cause_of_death(int status, const ReaderLimits& limits) {
  if (WIFSIGNALED(status)) {
    const int signal = WTERMSIG(status);
    if (signal == SIGXCPU || signal == SIGKILL) return too_long(limits.cpu_s);
    if (signal == SIGXFSZ)
      return "the file unpacks to more than " + std::to_string(limits.file_bytes / 1'000'000) +
             " MB; it is damaged or made to fill disks; copy it again, or cut out your area and period";
    return std::string{"the file is damaged in a way that stops its reader ("} + strsignal(signal) +
           "), or needs more than " + std::to_string(limits.memory_bytes / 1'000'000) +
           " MB of memory; copy or download it again";
  }
  return "the file is damaged in a way that stops its reader; copy or download it again";
}

void note(const Failed& failed, const ReaderLimits& limits, Told& told) {
  switch (failed.cause) {
    case Failed::Cause::memory: told.breakdown = too_large(limits.memory_bytes); return;
    case Failed::Cause::reader:
      told.breakdown = "the file cannot be read: " + failed.reason + "; copy or download it again";
      return;
    case Failed::Cause::store: throw std::runtime_error{failed.reason};
  }
}

/// Listens to a process until it has finished, died or was stopped.
Told listen(ReaderProcess& process, const ReaderLimits& limits, const std::stop_token& stop,
            const core::ProgressCallback& progress) {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds{limits.wall_s};
  Told told;
  while (true) {
    const auto reading = process.read_line(stop, deadline);
    if (reading == ReaderProcess::Reading::stopped) {
      told.stopped = true;
      return told;
    }
    if (reading == ReaderProcess::Reading::too_late) {
      told.breakdown = too_long(limits.wall_s);
      return told;
    }
    if (reading == ReaderProcess::Reading::ended) {
      told.breakdown = cause_of_death(process.wait(), limits);
      return told;
    }
    const auto event = parse_reader_event(process.line());
    if (!event) {
      told.breakdown = cause_of_death(process.kill(), limits);
      return told;
    }
    if (const auto* made = std::get_if<Progressed>(&*event); made && progress)
      progress(made->stage, made->share);
    if (const auto* look = std::get_if<LooksAt>(&*event)) told.looks_at = look->file;
    if (const auto* grouped = std::get_if<Grouped>(&*event)) told.grouped = *grouped;
    if (const auto* reported = std::get_if<Reported>(&*event)) told.reports.push_back(reported->report);
    if (const auto* failed = std::get_if<Failed>(&*event)) note(*failed, limits, told);
    if (std::holds_alternative<Finished>(*event)) return told;
  }
}

Told run_reader(const Guard& guard, const std::filesystem::path& staging, const FileGroup& files,
                ReaderRequest request, const std::stop_token& stop, const core::ProgressCallback& progress) {
  request.limits = limits_for(files);
  request.limits.cpu_s = std::min(request.limits.cpu_s, guard.most_cpu_s.value_or(request.limits.cpu_s));
  std::ofstream{staging / reader_request_file, std::ios::binary} << to_text(request);
  std::vector<std::string> arguments{"read-files", staging.string()};
  for (const auto& file : files) arguments.push_back(std::filesystem::absolute(file).string());
  ReaderProcess process{guard.program, arguments};
  return listen(process, request.limits, stop, progress);
}

/// Whether every file is in one group, and in one only: what a broken process says is not believed.
bool is_partition(const Grouped& grouped, std::size_t count) {
  std::set<std::size_t> seen;
  for (const auto& group : grouped.groups) {
    if (group.empty()) return false;
    for (const std::size_t file : group)
      if (file >= count || !seen.insert(file).second) return false;
  }
  return seen.size() == count;
}

/// Puts together what belongs together. A file on which the process breaks down is left out and asked about no more: it
/// makes a group of its own, and is refused when it is read.
std::vector<FileGroup> guarded_groups(const Guard& guard, FileGroup files, const std::stop_token& stop) {
  std::vector<FileGroup> groups;
  while (files.size() > 1 && !stop.stop_requested()) {
    const StagingFolder staging{guard.staging};
    const Told told =
        run_reader(guard, staging.path(), files,
                   {.task = ReaderRequest::Task::group, .options = {}, .now = {}, .limits = {}}, stop, {});
    if (told.breakdown.empty() && told.grouped && is_partition(*told.grouped, files.size())) {
      for (const auto& numbers : told.grouped->groups) {
        FileGroup& group = groups.emplace_back();
        for (const std::size_t number : numbers) group.push_back(files[number]);
      }
      return groups;
    }
    const auto culprit =
        files.begin() + static_cast<std::ptrdiff_t>(std::min(told.looks_at, files.size() - 1));
    groups.push_back({*culprit});
    files.erase(culprit);
  }
  for (const auto& file : files) groups.push_back({file});
  return groups;
}

/// A store for one group of files. It lists what is stored already, so that the same file is not read twice.
void prepare_scratch_store(sqlite::Connection& db, const std::filesystem::path& folder) {
  auto scratch = repository::open_scratch_store(folder);
  repository::DatasetRepository listed{scratch};
  for (const auto& dataset : repository::DatasetRepository{db}.list()) listed.insert(dataset);
}

/// Completes a report of the child with the dataset as it is now stored here. Another process may have stored the same
/// file meanwhile.
IngestReport completed(sqlite::Connection& db, IngestReport report,
                       const std::vector<repository::DatasetId>& taken_over) {
  if (!report.dataset) return report;
  const repository::DatasetId id = report.dataset->id;
  report.dataset = repository::DatasetRepository{db}.find(id);
  if (report.status == IngestStatus::stored && std::ranges::find(taken_over, id) == taken_over.end()) {
    report.status = IngestStatus::unchanged;
    report.warnings.clear();
  }
  return report;
}

std::optional<std::vector<IngestReport>> ingest_one_group(sqlite::Connection& db, const Guard& guard,
                                                          const FileGroup& files,
                                                          const IngestOptions& options, core::UtcTime now,
                                                          const std::stop_token& stop,
                                                          const core::ProgressCallback& progress) {
  const StagingFolder staging{guard.staging};
  prepare_scratch_store(db, staging.path());
  Told told = run_reader(guard, staging.path(), files,
                         {.task = ReaderRequest::Task::ingest, .options = options, .now = now, .limits = {}},
                         stop, progress);
  if (told.stopped) return std::nullopt;
  if (told.breakdown.empty() && told.reports.empty()) told.breakdown = cause_of_death(0, {});
  if (!told.breakdown.empty()) return std::vector{refused(files, told.breakdown)};
  const auto is_stored = [](const IngestReport& report) { return report.status == IngestStatus::stored; };
  std::vector<repository::DatasetId> taken_over;
  if (std::ranges::any_of(told.reports, is_stored))
    taken_over = repository::take_over_datasets(db, staging.path());
  std::vector<IngestReport> reports;
  for (IngestReport& report : told.reports) reports.push_back(completed(db, std::move(report), taken_over));
  return reports;
}

}  // namespace

std::vector<IngestReport> guarded_ingest(sqlite::Connection& db, const Guard& guard,
                                         const std::vector<std::filesystem::path>& files,
                                         const IngestOptions& options, core::UtcTime now,
                                         const std::stop_token& stop, const core::ProgressCallback& progress,
                                         const std::function<void(const IngestReport&)>& reported) {
  std::vector<IngestReport> reports;
  const std::vector<FileGroup> groups = guarded_groups(guard, files, stop);
  for (std::size_t i = 0; i < groups.size() && !stop.stop_requested(); ++i) {
    const auto of_all = [&](std::string_view stage, double share) {
      if (progress) progress(stage, (static_cast<double>(i) + share) / static_cast<double>(groups.size()));
    };
    auto of_group = ingest_one_group(db, guard, groups[i], options, now, stop, of_all);
    if (!of_group) break;
    for (IngestReport& report : *of_group) {
      report.files = groups[i];
      if (reported) reported(report);
      reports.push_back(std::move(report));
    }
  }
  return reports;
}

}  // namespace floeplan::ingest

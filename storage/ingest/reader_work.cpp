#include "storage/ingest/reader_work.hpp"

#include <sys/wait.h>

#include <algorithm>
#include <csignal>
#include <cstring>
#include <fstream>
#include <stdexcept>

#include "storage/ingest/reader_main.hpp"
#include "storage/ingest/reader_process.hpp"

namespace floeplan::ingest {
namespace {

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
    if (const auto* unpacked = std::get_if<UnpackedArchive>(&*event)) told.unpacked = *unpacked;
    if (const auto* reported = std::get_if<Reported>(&*event)) told.reports.push_back(reported->report);
    if (const auto* failed = std::get_if<Failed>(&*event)) note(*failed, limits, told);
    if (std::holds_alternative<Finished>(*event)) return told;
  }
}

}  // namespace

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

std::string unexplained_end() { return cause_of_death(0, {}); }

}  // namespace floeplan::ingest

#include "storage/ingest/process/reader_work.hpp"

#include <sys/wait.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fstream>
#include <stdexcept>

#include "engine/messages/ingest_file_messages.hpp"
#include "storage/ingest/process/reader_main.hpp"
#include "storage/ingest/process/reader_process.hpp"
#include "storage/repository/datasets/dataset_rows.hpp"

namespace floeplan::ingest {
namespace {

constexpr std::uint64_t bytes_per_megabyte = 1'000'000;

messages::Message too_long(std::uint64_t seconds) {
  return messages::ingest_file_message<"reading-took-too-long">(seconds);
}

/// Why a process ended before its work was done.
messages::Message cause_of_death(int status, const ReaderLimits& limits) {
  if (!WIFSIGNALED(status)) return messages::ingest_file_message<"reader-ended">();
  const int signal = WTERMSIG(status);
  if (signal == SIGXCPU || signal == SIGKILL) return too_long(limits.cpu_s);
  if (signal == SIGXFSZ)
    return messages::ingest_file_message<"unpacks-to-too-much">(limits.file_bytes / bytes_per_megabyte);
  return messages::ingest_file_message<"reader-killed">(std::string{strsignal(signal)},
                                                        limits.memory_bytes / bytes_per_megabyte);
}

void note(const Failed& failed, const ReaderLimits& limits, Told& told) {
  switch (failed.cause) {
    case Failed::Cause::memory:
      told.breakdown = messages::ingest_file_message<"reading-needs-too-much-memory">(limits.memory_bytes /
                                                                                      bytes_per_megabyte);
      return;
    case Failed::Cause::reader:
      told.breakdown = messages::ingest_file_message<"reader-failed">();
      told.technical_cause = failed.reason;
      return;
    case Failed::Cause::store: throw std::runtime_error{failed.reason};
    case Failed::Cause::sandbox:
      told.breakdown = messages::ingest_file_message<"reader-not-confined">(failed.reason);
      return;
  }
}

/// Listens to a process until it has finished, has died or was stopped. A damaged file may have changed what
/// it sends.
class Listening {
 public:
  Listening(ReaderProcess& process, const ReaderRequest& request, const std::stop_token& stop,
            const core::ProgressCallback& progress, const std::function<void(std::string_view)>& rows)
      : process_{process},
        request_{request},
        stop_{stop},
        progress_{progress},
        rows_{rows},
        deadline_{std::chrono::steady_clock::now() + std::chrono::seconds{request.limits.wall_s}} {}

  [[nodiscard]] Told listen() {
    while (!told_.breakdown && !told_.stopped) {
      if (!heard(process_.read_line(stop_, deadline_))) break;
      const auto event = parse_reader_event(process_.line());
      if (event && std::holds_alternative<Finished>(*event)) break;
      if (!event || !std::visit([&](const auto& said) { return take(said); }, *event))
        told_.breakdown = cause_of_death(process_.kill(), request_.limits);
    }
    if (!told_.breakdown && !told_.stopped && !told_.layers) told_.breakdown = unexplained_end();
    return std::move(told_);
  }

 private:
  static constexpr std::size_t most_reports = 100;  // of one group, which holds a few kinds of data

  /// Whether the reading succeeded, so that more can follow. If not, `told_` says why.
  bool heard(ReaderProcess::Reading reading) {
    switch (reading) {
      case ReaderProcess::Reading::line: return true;
      case ReaderProcess::Reading::stopped: told_.stopped = true; return false;
      case ReaderProcess::Reading::too_late: told_.breakdown = too_long(request_.limits.wall_s); return false;
      case ReaderProcess::Reading::ended:
        told_.breakdown = cause_of_death(process_.wait(), request_.limits);
        return false;
    }
    return false;
  }

  // Each overload returns whether this event is allowed at this point. No event is allowed before the process
  // has confined itself.
  bool take(const Confined& confined) {
    if (told_.layers) return false;
    told_.layers = confined.layers;
    return true;
  }
  bool take(const Progressed& made) {
    if (progress_) progress_(made.stage, made.share);
    return may_work();
  }
  bool take(const LooksAt& look) {
    told_.looks_at = look.file;
    return may_work();
  }
  bool take(const Grouped& grouped) {
    told_.grouped = grouped;
    return may_work();
  }
  bool take(const UnpackedArchive& unpacked) {
    told_.unpacked = unpacked;
    return may_work();
  }
  bool take(const Reported& reported) {
    told_.reports.push_back(reported.report);
    return may_work() && told_.reports.size() <= most_reports;
  }
  bool take(const Failed& failed) {
    note(failed, request_.limits, told_);
    return true;
  }
  bool take(const RowsFollow& parcel) {
    rows_bytes_ += parcel.bytes;
    if (!may_work() || !rows_ || parcel.bytes > repository::largest_parcel_bytes ||
        rows_bytes_ > 2 * request_.limits.file_bytes)
      return false;
    if (!heard(process_.read_bytes(parcel.bytes, stop_, deadline_))) return true;
    try {
      rows_(process_.line());
    } catch (const repository::BrokenParcel&) {
      return false;
    }
    return true;
  }
  static bool take(const Finished&) { return true; }

  [[nodiscard]] bool may_work() const {
    return told_.layers && (sandbox::is_enough(*told_.layers) || request_.allow_weak_sandbox);
  }

  ReaderProcess& process_;
  const ReaderRequest& request_;
  const std::stop_token& stop_;
  const core::ProgressCallback& progress_;
  const std::function<void(std::string_view)>& rows_;
  const std::chrono::steady_clock::time_point deadline_;
  std::uint64_t rows_bytes_{};
  Told told_;
};

}  // namespace

Told run_reader(const Guard& guard, const std::filesystem::path& staging, const FileGroup& files,
                ReaderRequest request, const std::stop_token& stop, const core::ProgressCallback& progress,
                const std::function<void(std::string_view)>& rows) {
  request.limits = limits_for(files);
  request.limits.cpu_s = std::min(request.limits.cpu_s, guard.most_cpu_s.value_or(request.limits.cpu_s));
  request.allow_weak_sandbox = guard.allow_weak_sandbox;
  std::ofstream{staging / reader_request_file, std::ios::binary} << to_text(request);
  const std::filesystem::path home = std::filesystem::absolute(staging);
  std::vector<std::string> arguments{"read-files", home.string()};
  for (const auto& file : files) arguments.push_back(std::filesystem::absolute(file).string());
  ReaderProcess process{guard.program, arguments, home};
  return Listening{process, request, stop, progress, rows}.listen();
}

messages::Message unexplained_end() { return cause_of_death(0, {}); }

}  // namespace floeplan::ingest

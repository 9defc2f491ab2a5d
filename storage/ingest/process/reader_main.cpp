#include "storage/ingest/process/reader_main.hpp"

#include <fcntl.h>
#include <malloc.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <fstream>
#include <iterator>
#include <new>
#include <stdexcept>

#include "storage/ingest/file_groups.hpp"
#include "storage/ingest/files/archive.hpp"
#include "storage/ingest/format_of.hpp"
#include "storage/ingest/ingest_file.hpp"
#include "storage/ingest/process/reader_messages.hpp"
#include "storage/ingest/process/reader_needs.hpp"
#include "storage/repository/datasets/dataset_rows.hpp"
#include "storage/repository/store/migrations.hpp"
#include "storage/sandbox/confinement.hpp"
#include "storage/sql/driver/failure.hpp"

namespace floeplan::ingest {
namespace {

/// The system kills this process when its parent ends, because nobody would read its answers.
void bind_to_parent() { prctl(PR_SET_PDEATHSIG, SIGKILL); }

/// Keeps freed memory in this process. Each slice needs the same megabytes; returning them to the kernel each
/// time takes longer than reading the slice.
void keep_freed_memory() {
  mallopt(M_MMAP_THRESHOLD, 32 << 20);  // bytes; the largest that the library accepts
  mallopt(M_TRIM_THRESHOLD, 256 << 20);
}

/// Writes events to the pipe to the parent. Output that libraries print on standard output and error is
/// discarded.
class Reporter {
 public:
  Reporter() : pipe_{fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, STDERR_FILENO + 1)} {
    const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
    if (pipe_ < 0 || nowhere < 0) throw std::runtime_error{"no pipe to report by"};
    dup2(nowhere, STDOUT_FILENO);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    dup2(nowhere, STDERR_FILENO);
#endif
    close(nowhere);
  }

  void tell(const ReaderEvent& event) const { send(to_text(event) + '\n'); }

  void send(std::string_view bytes) const {
    while (!bytes.empty()) {
      const ssize_t count = write(pipe_, bytes.data(), bytes.size());
      if (count <= 0) _exit(1);  // the parent has closed the pipe
      bytes.remove_prefix(static_cast<std::size_t>(count));
    }
  }

 private:
  int pipe_;
};

/// Reports progress once for each whole percent, not for each call.
core::ProgressCallback progress_to(const Reporter& reporter) {
  return [&reporter, last_stage = std::string{}, last_percent = -1.0](std::string_view stage,
                                                                      double share) mutable {
    const double percent = std::floor(100.0 * share);
    if (percent == last_percent && stage == last_stage) return;
    last_stage = stage;
    last_percent = percent;
    reporter.tell(Progressed{last_stage, share});
  };
}

Grouped group(const std::vector<std::filesystem::path>& files, const Reporter& reporter) {
  Grouped grouped;
  for (const FileGroup& members :
       group_files(files, [&](std::size_t file) { reporter.tell(LooksAt{file}); })) {
    auto& numbers = grouped.groups.emplace_back();
    for (const auto& member : members)
      numbers.push_back(static_cast<std::size_t>(std::ranges::find(files, member) - files.begin()));
  }
  return grouped;
}

/// Unpacks an archive and reports its content, or why it is refused.
ReaderEvent unpacked(const std::filesystem::path& archive, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  const auto is_data = [](const std::filesystem::path& file) { return format_of(file).has_value(); };
  const auto found = unpack(archive, folder, is_data);
  if (!found) return Reported{refused({archive}, {}, found.error())};
  UnpackedArchive told{.data = {}, .left_out = found->left_out};
  for (const auto& file : found->data) told.data.push_back(file.lexically_relative(folder).string());
  return told;
}

void hand_over_what_was_stored(sql::Connection& db, const std::vector<IngestReport>& reports,
                               const Reporter& reporter) {
  std::vector<repository::DatasetId> stored;
  for (const IngestReport& report : reports)
    if (report.status == IngestStatus::stored) stored.push_back(report.dataset->id);
  repository::send_datasets(db, stored, [&](std::string_view parcel) {
    reporter.tell(RowsFollow{parcel.size()});
    reporter.send(parcel);
  });
}

void work(const ReaderRequest& request, const std::filesystem::path& staging,
          const std::vector<std::filesystem::path>& files, const Reporter& reporter) {
  if (request.task == ReaderRequest::Task::probe) return;
  if (request.task == ReaderRequest::Task::unpack)
    return reporter.tell(unpacked(files.front(), staging / unpacked_folder));
  if (request.task == ReaderRequest::Task::group) return reporter.tell(group(files, reporter));
  auto db = repository::open_scratch_store(staging);
  std::vector<IngestReport> reports =
      ingest_group(db, files, request.options, request.now, progress_to(reporter));
  hand_over_what_was_stored(db, reports, reporter);
  for (IngestReport& report : reports) reporter.tell(Reported{std::move(report)});
}

/// Takes away every right that reading does not need.
/// Returns  whether the confinement is strong enough to open files from outside
bool is_confined(const ReaderRequest& request, const std::filesystem::path& staging,
                 const std::vector<std::filesystem::path>& files, const Reporter& reporter) {
  keep_to(request.limits);
  prepare_libraries();
  const sandbox::Layers layers = sandbox::confine(needs_of_reader(files, staging));
  reporter.tell(Confined{layers});
  if (sandbox::is_enough(layers) || request.allow_weak_sandbox) return true;
  reporter.tell(Failed{Failed::Cause::sandbox, sandbox::to_text(layers)});
  return false;
}

ReaderRequest read_request(const std::filesystem::path& staging) {
  std::ifstream in{staging / reader_request_file, std::ios::binary};
  return parse_reader_request({std::istreambuf_iterator<char>{in}, {}});
}

}  // namespace

int read_foreign_files(const std::filesystem::path& staging,
                       const std::vector<std::filesystem::path>& files) {
  bind_to_parent();
  keep_freed_memory();
  std::filesystem::current_path(staging);
  const ReaderRequest request = read_request(staging);
  const Reporter reporter;
  try {
    if (is_confined(request, staging, files, reporter)) work(request, staging, files, reporter);
  } catch (const std::bad_alloc&) {
    reporter.tell(Failed{Failed::Cause::memory, ""});
  } catch (const sql::Failure& failure) {
    reporter.tell(Failed{Failed::Cause::store, failure.what()});
  } catch (const std::exception& fault) {
    reporter.tell(Failed{Failed::Cause::reader, fault.what()});
  }
  reporter.tell(Finished{});
  return 0;
}

}  // namespace floeplan::ingest

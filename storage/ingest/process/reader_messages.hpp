#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "storage/ingest/common/ingest_options.hpp"
#include "storage/ingest/ingest_report.hpp"
#include "storage/ingest/process/reader_limits.hpp"
#include "storage/sandbox/confinement.hpp"

namespace floeplan::ingest {

/// The task of a process that reads files from outside.
struct ReaderRequest {
  enum class Task {
    unpack,  // unpack the one file, which is an archive
    group,   // report which of the files belong together
    probe,   // report how it is confined
    ingest   // read the files, which make one group, into the store
  };
  Task task{Task::ingest};
  IngestOptions options;
  core::UtcTime now;
  ReaderLimits limits;
  bool allow_weak_sandbox{false};  // work even if the sandbox has fewer layers than required
};

/// The events that the process reports while it works. Each kind can occur several times; Confined comes
/// before a file is opened.
struct Confined {  // before a file is opened
  sandbox::Layers layers;
};
struct Progressed {
  std::string stage;
  double share{};  // 0 to 1
};
struct LooksAt {
  std::size_t file{};  // index of the file that is opened to find its group
};
struct Grouped {
  std::vector<std::vector<std::size_t>> groups;  // each group as indices of files
};
struct UnpackedArchive {  // names below `unpacked_folder` of the staging folder
  std::vector<std::string> data;
  std::vector<std::string> left_out;
};
struct RowsFollow {  // a parcel of rows of the datasets follows this line
  std::size_t bytes{};
};
struct Reported {
  IngestReport report;
};
struct Failed {
  enum class Cause {
    memory,  // more memory than the limit
    reader,  // an exception that the reader does not expect
    store,   // a fault of the machine, not of the file
    sandbox  // the process cannot be confined
  };
  Cause cause{Cause::reader};
  std::string reason;
};
struct Finished {};  // the last event; without it the process broke down

using ReaderEvent = std::variant<Confined, Progressed, LooksAt, Grouped, UnpackedArchive, RowsFollow,
                                 Reported, Failed, Finished>;

/// JSON texts. An event is one line, without the line end.
[[nodiscard]] std::string to_text(const ReaderRequest& request);
[[nodiscard]] std::string to_text(const ReaderEvent& event);

/// Errors   std::runtime_error for a text that is not a request
[[nodiscard]] ReaderRequest parse_reader_request(const std::string& text);
/// nullopt for a line that is not an event: a file may have broken the process that wrote it. A dataset in a
/// report has only its id.
[[nodiscard]] std::optional<ReaderEvent> parse_reader_event(const std::string& line);

}  // namespace floeplan::ingest

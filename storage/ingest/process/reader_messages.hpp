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

/// What a process that reads foreign files is to do.
struct ReaderRequest {
  enum class Task {
    unpack,  // lay out what the one file, an archive, holds
    group,   // say which of the files belong together
    probe,   // say how it is confined
    ingest   // read the files, which make one group, into the store
  };
  Task task{Task::ingest};
  IngestOptions options;
  core::UtcTime now;
  ReaderLimits limits;
  bool allow_weak_sandbox{false};  // work in fewer layers than are needed
};

/// What it tells while it works, in this order as often as there is something to tell.
struct Confined {  // before it opens a file
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
  std::vector<std::vector<std::size_t>> groups;  // of the files' numbers
};
struct UnpackedArchive {  // names below `unpacked_folder` of the staging folder
  std::vector<std::string> data;
  std::vector<std::string> left_out;
};
struct RowsFollow {  // the line is followed by a parcel of rows of the datasets that were read
  std::size_t bytes{};
};
struct Reported {
  IngestReport report;
};
struct Failed {
  enum class Cause {
    memory,  // more than the limit
    reader,  // an error that no reader has foreseen
    store,   // the machine's, not the file's
    sandbox  // it cannot be confined
  };
  Cause cause{Cause::reader};
  std::string reason;
};
struct Finished {};  // the last one; without it the process broke down

using ReaderEvent = std::variant<Confined, Progressed, LooksAt, Grouped, UnpackedArchive, RowsFollow,
                                 Reported, Failed, Finished>;

/// JSON texts. An event is one line without its end.
[[nodiscard]] std::string to_text(const ReaderRequest& request);
[[nodiscard]] std::string to_text(const ReaderEvent& event);

/// Errors   std::runtime_error for a text that is none
[[nodiscard]] ReaderRequest parse_reader_request(const std::string& text);
/// Nothing of a line that is no event: the process that wrote it may have been broken by a file. Of a dataset in a
/// report only the id is there.
[[nodiscard]] std::optional<ReaderEvent> parse_reader_event(const std::string& line);

}  // namespace floeplan::ingest

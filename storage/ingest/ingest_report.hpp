#pragma once

#include <optional>
#include <string>
#include <vector>

#include "storage/ingest/common/refusal.hpp"
#include "storage/ingest/files/file_group.hpp"
#include "storage/repository/datasets/dataset.hpp"

namespace floeplan::ingest {

enum class IngestStatus { stored, refused, unchanged };

/// The result for one kind of data in a file. From a refused file nothing is stored.
struct IngestReport {
  std::string file;  // file names; "u.nc + v.nc" for files that were read together
  IngestStatus status{IngestStatus::refused};
  std::optional<repository::Dataset> dataset;  // empty when refused
  Messages warnings;                           // what the reader assumed, changed or ignored
  Messages errors;                             // empty unless refused
  FileGroup files{};                           // the files named in `file`; set by guarded_ingest
  /// The exception that ended the reader, in the words of its library: for a log, never for a pilot. Usually empty.
  std::string technical_cause{};
};

}  // namespace floeplan::ingest

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "storage/ingest/files/file_group.hpp"
#include "storage/repository/datasets/dataset.hpp"

namespace floeplan::ingest {

enum class IngestStatus { stored, refused, unchanged };

/// What became of one kind of data in a file. A refused file stores nothing.
struct IngestReport {
  std::string file;  // "u.nc + v.nc" of files that were read together
  IngestStatus status{IngestStatus::refused};
  std::optional<repository::Dataset> dataset;  // empty when refused
  std::vector<std::string> warnings;
  std::vector<std::string> errors;  // each: what; why; what to do
  FileGroup files{};                // what `file` names; set by guarded_ingest
};

}  // namespace floeplan::ingest

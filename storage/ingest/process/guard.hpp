#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

namespace floeplan::ingest {

/// How files from outside are kept away from this process.
struct Guard {
  std::filesystem::path
      // this program's own file; started as `program read-files STAGING FILE...`, it calls read_foreign_files
      program;
  std::filesystem::path staging;  // folder for data that are not complete yet; on the store's disk
  std::optional<std::uint64_t> most_cpu_s{};  // limit of computing time, if lower than the limit by file size
  bool allow_weak_sandbox{false};  // read files even on a machine that cannot confine their readers
};

}  // namespace floeplan::ingest

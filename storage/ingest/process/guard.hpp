#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

namespace floeplan::ingest {

/// How foreign files are kept away from this process.
struct Guard {
  std::filesystem::path
      program;  // ours: started as `program read-files STAGING FILE...`, it calls read_foreign_files
  std::filesystem::path staging;  // folder for data that are not complete yet; on the store's disk
  std::optional<std::uint64_t>
      most_cpu_s{};                // computing time, where it shall be less than files of a size may take
  bool allow_weak_sandbox{false};  // read files even where the machine cannot confine their readers
};

}  // namespace floeplan::ingest

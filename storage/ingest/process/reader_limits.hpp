#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace floeplan::ingest {

/// What a process that reads foreign files may take of the machine.
struct ReaderLimits {
  std::uint64_t memory_bytes{};   // private memory; what maps a file for reading does not count
  std::uint64_t address_bytes{};  // everything it maps
  std::uint64_t cpu_s{};          // computing time
  std::uint64_t wall_s{};         // time by the clock, watched from outside
  std::uint64_t file_bytes{};     // of the largest file that it writes
  std::uint64_t open_files{};
};

/// Enough for every good file of this size, and too little for a small file that pretends to be a large one.
[[nodiscard]] ReaderLimits limits_for(const std::vector<std::filesystem::path>& files);

/// Bounds this process, for good. Without bounds on memory under the address and thread sanitizers, which map
/// terabytes.
/// Errors   std::system_error when the system refuses
void keep_to(const ReaderLimits& limits);

}  // namespace floeplan::ingest

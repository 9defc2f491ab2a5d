#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace floeplan::ingest {

/// Limits on the resources of a process that reads files from outside.
struct ReaderLimits {
  std::uint64_t memory_bytes{};   // private memory; a file mapped for reading does not count
  std::uint64_t address_bytes{};  // all mapped addresses
  std::uint64_t cpu_s{};          // computing time
  std::uint64_t wall_s{};         // elapsed time, watched by the parent process
  std::uint64_t file_bytes{};     // size of the largest file that it writes
  std::uint64_t open_files{};
};

/// Limits that are enough for every valid file of this size, but too little for a small file that pretends to
/// be large.
[[nodiscard]] ReaderLimits limits_for(const std::vector<std::filesystem::path>& files);

/// Sets the limits for this process, permanently. Memory is not limited under the address and thread
/// sanitizers, which map terabytes.
/// Errors   std::system_error when the system refuses
void keep_to(const ReaderLimits& limits);

}  // namespace floeplan::ingest

#include "storage/ingest/process/reader_limits.hpp"

#include <sys/resource.h>

#include <cerrno>
#include <system_error>

namespace floeplan::ingest {
namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool sanitized = true;
#else
constexpr bool sanitized = false;
#endif

constexpr std::uint64_t megabyte = 1'000'000;

/// Bytes of a file, or of everything in a folder; 0 if it does not exist.
std::uint64_t bytes_of(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_directory(path, error)) {
    const auto size = std::filesystem::file_size(path, error);
    return error ? 0 : size;
  }
  std::uint64_t bytes = 0;
  for (auto entry = std::filesystem::recursive_directory_iterator{path, error};
       !error && entry != std::filesystem::recursive_directory_iterator{}; entry.increment(error)) {
    std::error_code none;
    if (!entry->is_symlink(none) && entry->is_regular_file(none)) bytes += entry->file_size(none);
  }
  return bytes;
}

void set_limit(decltype(RLIMIT_CPU) resource, std::uint64_t most) {
  const rlimit limit{most, most};
  if (setrlimit(resource, &limit) != 0)
    throw std::system_error{errno, std::generic_category(), "a limit of the reading process cannot be set"};
}

}  // namespace

ReaderLimits limits_for(const std::vector<std::filesystem::path>& files) {
  std::uint64_t bytes = 0;
  for (const std::filesystem::path& file : files) bytes += bytes_of(file);
  // Seconds. A damaged small file must be given up within 10 s of elapsed time; it gets half of this, because
  // the machine may be busy. Each megabyte adds half a second, ten times as long as one slow core takes to
  // read files of currents, the largest files.
  const std::uint64_t cpu_s = (sanitized ? 60 : 5) + bytes / megabyte / (sanitized ? 1 : 2);
  return {.memory_bytes = 480 * megabyte,
          .address_bytes = 4'000 * megabyte,  // libraries alone map about 500 MB
          .cpu_s = cpu_s,
          .wall_s = 60 + 10 * cpu_s,  // the machine may be busy
          .file_bytes = 512 * megabyte + 20 * bytes,
          .open_files = 128};
}

void keep_to(const ReaderLimits& limits) {
  set_limit(RLIMIT_CORE, 0);
  set_limit(RLIMIT_CPU, limits.cpu_s);
  set_limit(RLIMIT_FSIZE, limits.file_bytes);
  set_limit(RLIMIT_NOFILE, limits.open_files);
  if (sanitized) return;
  set_limit(RLIMIT_DATA, limits.memory_bytes);
  set_limit(RLIMIT_AS, limits.address_bytes);
}

}  // namespace floeplan::ingest

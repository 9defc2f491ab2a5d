#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "storage/ingest/common/refusal.hpp"
#include "storage/ingest/files/file_group.hpp"

namespace floeplan::ingest {

/// Whether the first bytes of a file are those of a Slocum's binary log (dbd, sbd, mbd and the like), unpacked where it
/// was compressed.
[[nodiscard]] bool is_slocum_binary(std::string_view head);
[[nodiscard]] bool holds_slocum_binary(const std::filesystem::path& file);

/// Whether they are those of a cache: the list of sensors that logs refer to by its checksum, "1f35be3b.cac".
[[nodiscard]] bool is_sensor_cache(std::string_view head);
[[nodiscard]] bool holds_sensor_cache(const std::filesystem::path& file);

/// Whether a cache, by its name, is the one that a log refers to.
[[nodiscard]] bool is_cache_of(const std::filesystem::path& cache, const std::filesystem::path& log);

/// What is left of the files of a group.
[[nodiscard]] FileGroup without_sensor_caches(const FileGroup& files);

/// A sensor that each cycle of a log has two bits for.
struct LoggedSensor {
  std::size_t bytes{};
  std::optional<std::size_t> wanted{};  // its place in slocum_sensors
};

/// What stands before the cycles of a log, or in the cache that it refers to.
struct SlocumHeader {
  std::vector<LoggedSensor> sensors;  // in the order of their bits
  std::size_t size{};                 // in the log, in bytes
};

/// Takes the beginning of a binary log apart; `bytes` are the log's. The list of sensors of a factored log is in its
/// cache: among `given`, else beside the log.
/// Format   lines "key: value"; the list of sensors unless factored
/// Errors   a sensor in another unit than masterdata's; a cache that is not there or does not fit
[[nodiscard]] Checked<SlocumHeader> slocum_header_of(const std::filesystem::path& log, std::string_view bytes,
                                                     const FileGroup& given);

}  // namespace floeplan::ingest

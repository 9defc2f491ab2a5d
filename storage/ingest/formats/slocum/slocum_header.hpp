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

/// Whether a file is a binary Slocum log (dbd, sbd, mbd and the like): by its first bytes, unpacked if they
/// were compressed.
[[nodiscard]] bool is_slocum_binary(std::string_view head);
[[nodiscard]] bool holds_slocum_binary(const std::filesystem::path& file);

/// Whether a file is a sensor cache: a list of sensors to which logs refer by its checksum, "1f35be3b.cac".
[[nodiscard]] bool is_sensor_cache(std::string_view head);
[[nodiscard]] bool holds_sensor_cache(const std::filesystem::path& file);

/// Whether the name of a cache is the one to which a log refers.
[[nodiscard]] bool is_cache_of(const std::filesystem::path& cache, const std::filesystem::path& log);

/// The files of a group without its sensor caches.
[[nodiscard]] FileGroup without_sensor_caches(const FileGroup& files);

/// A sensor of a log; each cycle has two bits for it.
struct LoggedSensor {
  std::size_t bytes{};
  std::optional<std::size_t> wanted{};  // its index in slocum_sensors; empty: not used
};

/// The header of a log, with the sensors from the log itself or from its cache.
struct SlocumHeader {
  std::vector<LoggedSensor> sensors;  // in the order of their bits
  std::size_t size{};                 // length of the header in the log, bytes
};

/// Decodes the beginning of a binary log; `bytes` are the log's. A factored log has its list of sensors in a
/// cache, which is taken from `given` or found beside the log.
/// Format   lines "key: value"; the list of sensors unless factored
/// Errors   a sensor in another unit than in masterdata; the sensor cache is missing or does not match
[[nodiscard]] Checked<SlocumHeader> slocum_header_of(const std::filesystem::path& log, std::string_view bytes,
                                                     const FileGroup& given);

}  // namespace floeplan::ingest

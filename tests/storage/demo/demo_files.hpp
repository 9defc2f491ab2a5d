#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/core/units.hpp"
#include "storage/demo/write_demo.hpp"

namespace floeplan::demo {

inline constexpr core::UtcTime first_hour{core::Seconds{1'795'305'600.0}};  // 2026-11-22T00:00:00Z

/// False where the coastline of the disko scenario is not installed.
[[nodiscard]] bool has_shoreline();

/// A scenario's files in a directory of the test run, written on the first call.
[[nodiscard]] std::vector<std::filesystem::path> demo_files(Scenario scenario, std::uint64_t seed,
                                                            const std::string& directory);

[[nodiscard]] std::string bytes_of(const std::filesystem::path& file);

/// A velocity component of a currents file, unpacked; missing nodes are not finite.
struct Component {
  std::vector<double> times_s;
  std::vector<double> depth_m;
  std::vector<double> lat_deg;
  std::vector<double> lon_deg;
  std::vector<double> m_s;  // [time][depth][latitude][longitude]

  [[nodiscard]] double at(std::size_t time, std::size_t depth, std::size_t row, std::size_t column) const {
    return m_s[((time * depth_m.size() + depth) * lat_deg.size() + row) * lon_deg.size() + column];
  }
};

[[nodiscard]] Component read_component(const std::filesystem::path& file, const std::string& name);

}  // namespace floeplan::demo

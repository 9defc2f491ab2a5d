#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "engine/core/units.hpp"

namespace floeplan::demo {

/// disko: Disko Bay and Ilulissat Icefjord on the true coast; river, jet: the fields of the reference paper
/// at sea scale.
enum class Scenario { disko, river, jet };

/// "disko", "river", "jet"; empty for any other name.
[[nodiscard]] std::optional<Scenario> parse_scenario(std::string_view name);

/// Writes the demonstration data of a scenario into a directory, which is made when missing: NetCDF, GeoTIFF
/// and GeoJSON as `ingest` takes them, and README.txt, which says what is invented. Files of the same name
/// are replaced.
/// Law      the same scenario, seed and start give the same bytes; river and jet do not depend on the seed
/// Returns  the data files, in the order in which they are best ingested; README.txt is not among them
/// Errors   std::runtime_error when a file cannot be written, and for disko when the package gmt-gshhg-full
///          is missing
std::vector<std::filesystem::path> write_demo(const std::filesystem::path& dir, Scenario scenario,
                                              std::uint64_t seed, core::UtcTime start);

}  // namespace floeplan::demo

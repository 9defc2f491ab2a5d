#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/units.hpp"

namespace floeplan::demo {

/// disko: Disko Bay and Ilulissat Icefjord on the true coast; strait: a narrows where the tide is stronger than a
/// glider; pack_ice: a belt of closed ice with leads; river, jet: the fields of the reference paper at sea scale.
enum class Scenario { disko, strait, pack_ice, river, jet };

/// The names of the scenarios for users, in the order of the enumeration: "disko", "strait", "pack-ice",
/// "river", "jet".
[[nodiscard]] const std::vector<std::string>& scenario_names();

/// Empty for any other name.
[[nodiscard]] std::optional<Scenario> parse_scenario(std::string_view name);

/// Arguments of the command `floeplan` for the plan that a scenario demonstrates, once its data are in the
/// store: across the bay; through the narrows, where the vehicle may hold until the tide turns; below the ice
/// with a limit on the time between surfacings; across the river; along the jet.
[[nodiscard]] std::vector<std::string> example_request(Scenario scenario, core::UtcTime start);

/// Writes the demonstration data of a scenario into a directory, which is created if missing: NetCDF, GeoTIFF
/// and GeoJSON files for the command `ingest`, and README.txt, which says what is invented. Files of the same
/// name are replaced.
/// Laws     the same scenario, seed and start give the same bytes; river and jet do not depend on the seed;
///          another start gives the same values at shifted times, except for the tide of disko, which depends
///          on the date
/// Returns  the data files, in the order in which they are best ingested; README.txt is not among them
/// Errors   std::runtime_error when a file cannot be written, and for disko when the package gmt-gshhg-full
///          is missing
std::vector<std::filesystem::path> write_demo(const std::filesystem::path& dir, Scenario scenario,
                                              std::uint64_t seed, core::UtcTime start);

}  // namespace floeplan::demo

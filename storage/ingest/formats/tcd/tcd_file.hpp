#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "storage/ingest/common/refusal.hpp"

namespace floeplan::ingest {

/// Whether a file begins like a database of harmonic constants for XTide.
[[nodiscard]] bool is_tcd(std::string_view head);

/// Compares a file's length with the length in its header.
/// Errors   the file was cut short, or its header states no length
[[nodiscard]] Checked<bool> is_whole_tcd(const std::filesystem::path& file);

struct TcdConstituent {
  std::string name;
  double speed_deg_h{};
};

struct TcdConstant {
  std::size_t constituent{};  // index in the file's list of constituents
  double amplitude{};         // in the unit of the station, greater than 0
  double phase_deg{};         // lag behind the equilibrium tide, in the standard time of the station's zone
};

struct TcdStation {
  std::string name;
  double lon_deg{};
  double lat_deg{};
  std::string unit;                    // "feet", "meters"; of a current "knots", "knots^2"
  double zone_h{};                     // hours east of UTC; phases count in this zone's time
  bool has_constants{true};            // false: the tides are given as differences from another station
  std::vector<TcdConstant> constants;  // empty: not stated
};

struct TcdFile {
  std::vector<TcdConstituent> constituents;
  std::vector<TcdStation> stations;
};

/// Reads a file with libtcd, which ends the process at an invalid record. Call is_whole_tcd first.
/// Errors   libtcd cannot open the file; more than 100,000 stations
/// Threads  one at a time in a process: libtcd keeps one open file
/// Source   libtcd 2.2.2, libtcd.html: "Format of the TCD file", TIDE_RECORD
[[nodiscard]] Checked<TcdFile> read_tcd(const std::filesystem::path& file);

}  // namespace floeplan::ingest

#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "storage/ingest/common/refusal.hpp"

namespace floeplan::ingest {

/// Whether a file begins as a database of harmonic constants of XTide does.
[[nodiscard]] bool is_tcd(std::string_view head);

/// Compares a file with the length that its header states.
/// Errors   a file that was cut short, or whose header states no length
[[nodiscard]] Checked<bool> is_whole_tcd(const std::filesystem::path& file);

struct TcdConstituent {
  std::string name;
  double speed_deg_h{};
};

struct TcdConstant {
  std::size_t constituent{};  // of the file's list
  double amplitude{};         // in the unit of the station, greater than 0
  double phase_deg{};         // behind the standard time of the station's zone
};

struct TcdStation {
  std::string name;
  double lon_deg{};
  double lat_deg{};
  std::string unit;                    // "feet", "meters"; of a current "knots", "knots^2"
  double zone_h{};                     // hours east of UTC that its phases count from
  bool has_constants{true};            // else its tides are stated as differences from another station's
  std::vector<TcdConstant> constants;  // none: not stated
};

struct TcdFile {
  std::vector<TcdConstituent> constituents;
  std::vector<TcdStation> stations;
};

/// Reads a file that is_whole_tcd has looked at through libtcd, which ends the process where a record breaks its rules.
/// Errors   a file that libtcd cannot open; more than 100,000 stations
/// Threads  one at a time in a process: libtcd knows one file
/// Source   libtcd 2.2.2, libtcd.html: "Format of the TCD file", TIDE_RECORD
[[nodiscard]] Checked<TcdFile> read_tcd(const std::filesystem::path& file);

}  // namespace floeplan::ingest

#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "storage/ingest/common/refusal.hpp"

namespace floeplan::ingest {

/// The header of one field of a GRIB2 file.
struct GribField {
  int discipline{};  // 10: oceanography
  int category{};
  int number{};
  int surface_type{};            // 160: a depth below the sea's surface
  double surface_value{};        // in the unit of the surface type
  int second_surface_type{255};  // end of a layer that begins at the first surface; 255: no layer
  double second_surface_value{};
  double valid_s{};  // seconds since 1970-01-01T00:00:00Z; for a mean the middle of its period
  std::optional<double>
      run_s{};          // when the forecast or its analysis began, likewise; empty: the time is another one
  int statistic{};      // over the time, code table 4.10; 0: a mean, or the value at one time
  int grid_template{};  // 0: latitude and longitude, 20: polar stereographic, ...
  std::string grid;     // octets of the grid section, to compare grids
  bool along_grid{false};  // vectors point along the grid's x and y, not towards east and north

  [[nodiscard]] bool is_of_layer() const { return second_surface_type != 255; }
};

/// Reads the headers of a GRIB2 file. GDAL decodes the values, but it does not say whether vectors are
/// relative to the grid or to east and north, nor that a file ends early.
/// Errors   GRIB of edition 1; lengths that do not fit the file; a time unit or a product that is not known
/// Source   WMO Manual on Codes No. 306, volume I.2, part B, FM 92 GRIB edition 2: templates 3.0, 3.1, 3.10, 3.20,
///          3.30, 4.0, 4.8; flag table 3.3; code tables 4.4, 4.5 and 4.10
[[nodiscard]] Checked<std::vector<GribField>> grib_fields(const std::filesystem::path& file);

}  // namespace floeplan::ingest

#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "storage/ingest/common/refusal.hpp"
#include "storage/ingest/formats/grib/grib_messages.hpp"
#include "storage/ingest/readers/currents/current_dataset.hpp"
#include "storage/ingest/readers/velocity/velocity_kind.hpp"
#include "storage/repository/datasets/dataset.hpp"

namespace floeplan::ingest {

/// Numbers of the raster bands of the two components at one time and depth; the first band is 1.
struct GribBands {
  int east{};
  int north{};
};

/// The content of the bands of a GRIB file.
struct GribContents {
  std::vector<double> times_s;
  std::vector<double> depths_m;  // for a layer its middle
  std::vector<GribBands> bands;  // [time][depth]
  std::optional<core::UtcTime>
      run;           // when the model run began; empty: the fields are from several runs or do not say
  std::string grid;  // the octets of section 3, equal for all these fields
  bool along_grid{false};
  bool has_depths{true};
  std::string layers;  // "0 to 10 m and 10 to 50 m" if the values are means over layers; otherwise empty
};

/// Finds the components of the current, or of the wind 10 m above the ground, among the fields of a GRIB
/// file.
/// Errors  no such fields, or speed and direction instead; a component is missing at a time or depth, or
///         occurs twice; fields on different grids; a surface that is not a depth; overlapping layers
[[nodiscard]] Checked<GribContents> grib_contents(const std::vector<GribField>& fields, Moving what);

/// The kinds of data in a GRIB file: currents, wind or both. If it has neither, currents, whose reader then
/// says so.
/// Errors   as grib_fields
[[nodiscard]] Checked<std::vector<repository::DatasetKind>> kinds_of_grib(const std::filesystem::path& file);

}  // namespace floeplan::ingest

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

/// Raster bands of the two components at one time and depth, from 1.
struct GribBands {
  int east{};
  int north{};
};

/// Which band holds what.
struct GribContents {
  std::vector<double> times_s;
  std::vector<double> depths_m;  // of a layer its middle
  std::vector<GribBands> bands;  // [time][depth]
  std::optional<core::UtcTime>
      run;           // when the model run began; empty: the fields are of several, or do not say
  std::string grid;  // the octets of section 3 of all those fields
  bool along_grid{false};
  bool has_depths{true};
  std::string layers;  // "0 to 10 m and 10 to 50 m", where the values are means over layers; else empty
};

/// Where among the fields of a GRIB file the components of the current, or of the wind 10 m above the ground, are.
/// Errors  no such fields, or speed and direction instead; a component missing at a time or depth, or there twice;
///         fields on different grids; a surface that is no depth; layers that overlap
[[nodiscard]] Checked<GribContents> grib_contents(const std::vector<GribField>& fields, Moving what);

/// Currents, wind or both; currents where there is neither, whose reader then says so.
/// Errors   as grib_fields
[[nodiscard]] Checked<std::vector<repository::DatasetKind>> kinds_of_grib(const std::filesystem::path& file);

}  // namespace floeplan::ingest

#pragma once

#include <optional>
#include <string>

#include "storage/ingest/formats/netcdf/netcdf_file.hpp"

namespace floeplan::ingest {

/// The depth of a current without a depth axis, from its name or long name: "u_15m", "velocity at 15 m", "15
/// m depth". Metres, positive down.
[[nodiscard]] std::optional<double> depth_in_words(const NetcdfVariable& variable);

/// The level of a wind, from its name ("u100", "ugrd_850mb"), its long name ("100 metre U wind component") or
/// the level of the GRIB field that it was converted from.
struct WindLevel {
  bool at_10_m{false};
  std::string words;  // "100 m", "850 hPa", "level 100"
};
[[nodiscard]] std::optional<WindLevel> wind_level_in_words(const NetcdfVariable& variable);

}  // namespace floeplan::ingest

#pragma once

#include <optional>
#include <string>

#include "engine/core/units.hpp"
#include "engine/geo/lon_lat.hpp"
#include "storage/repository/datasets/dataset.hpp"

namespace floeplan::ingest {

/// What the user said about a file beyond the file itself.
struct IngestOptions {
  std::optional<std::string> name{};              // default: the file's name without its ending
  std::optional<repository::DatasetKind> kind{};  // default: recognised
  std::optional<std::string> crs{};               // "EPSG:4326", for files that state none
  std::optional<std::string> positive{};          // "up" or "down", for bathymetry that does not say
  std::optional<geo::LonLat> at{};  // of a station of the tide whose file does not say where it is
  /// Where the file states none: "m", "cm", "mm" or "ft" of a tide station's amplitudes, "share" or "percent" of a
  /// concentration of sea ice.
  std::optional<std::string> unit{};
  std::optional<std::string> zone_kind{};  // "no_go" or "stay_in", for zones that do not say
  std::optional<std::string> variable{};   // of several pairs of currents or concentrations the one to use
  std::optional<double> missing{};         // what marks missing values in NetCDF that does not declare it
  /// For which sea ice holds, or when a run of ADCIRC began, where the file does not say it.
  std::optional<core::UtcTime> time{};
  std::optional<std::string> archive{};  // name of the one that the files were unpacked from
};

}  // namespace floeplan::ingest

#pragma once

#include <optional>
#include <string>

#include "engine/core/units.hpp"
#include "engine/geo/lon_lat.hpp"
#include "storage/repository/datasets/dataset.hpp"

namespace floeplan::ingest {

/// Statements of the user about a file that the file itself does not make.
struct IngestOptions {
  std::optional<std::string> name{};              // default: the file's name without its ending
  std::optional<repository::DatasetKind> kind{};  // default: recognised by content
  std::optional<std::string> crs{};               // "EPSG:4326", for files that state none
  std::optional<std::string> positive{};          // "up" or "down", for bathymetry that does not say
  std::optional<geo::LonLat> at{};                // place of a tide station, if its file does not state one
  /// Where the file states none: "m", "cm", "mm" or "ft" of a tide station's amplitudes, "share" or "percent" of a
  /// concentration of sea ice.
  std::optional<std::string> unit{};
  std::optional<std::string> zone_kind{};  // "no_go" or "stay_in", for zones that do not say
  // the variable to use if there are several pairs of currents or several concentrations
  std::optional<std::string> variable{};
  // the value that marks missing values in NetCDF files that declare none
  std::optional<double> missing{};
  /// Valid time of sea ice, or start of an ADCIRC run, if the file does not state it.
  std::optional<core::UtcTime> time{};
  std::optional<std::string> archive{};  // name of the archive that the files were unpacked from
};

}  // namespace floeplan::ingest

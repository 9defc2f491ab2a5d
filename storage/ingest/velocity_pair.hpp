#pragma once

#include <optional>
#include <string>
#include <vector>

#include "storage/ingest/netcdf_file.hpp"
#include "storage/ingest/refusal.hpp"

namespace floeplan::ingest {

/// The two components of the sea water's velocity in a file, towards true east and true north.
struct VelocityPair {
  const NetcdfVariable* east{nullptr};
  const NetcdfVariable* north{nullptr};
  std::vector<std::string> warnings;  // what the choice means for the pilot
};

/// Whether any variable claims to be a velocity of sea water, whether or not it can be used.
[[nodiscard]] bool holds_velocity(const NetcdfFile& file);

/// Chooses the pair by well-known names, then by standard names. Anomalies, wind, ice, waves are never taken.
/// Errors   one component alone; components along the axes of a grid; grids that this program does not read
[[nodiscard]] Checked<VelocityPair> find_velocity_pair(const NetcdfFile& file);

/// Metres per second in one of the variable's (unpacked) unit. A variable without a unit is taken as m/s and
/// says so in `warnings`; the size of its values has to confirm that.
[[nodiscard]] Checked<double> speed_factor_of(const NetcdfVariable& variable,
                                              std::vector<std::string>& warnings);

}  // namespace floeplan::ingest

#pragma once

#include <memory>
#include <string>
#include <vector>

#include "storage/ingest/netcdf_file.hpp"
#include "storage/ingest/refusal.hpp"

namespace floeplan::ingest {

/// What the two components of a velocity are measured along.
enum class VelocityAxes {
  east_north,  // true east and true north
  grid,        // the axes of the model's grid
  unstated     // the file does not say
};

/// The two components of the sea water's velocity, in one file or in two.
struct VelocityPair {
  const NetcdfVariable* first{nullptr};  // towards east, or along the grid's first axis
  const NetcdfVariable* second{nullptr};
  const NetcdfFile* first_file{nullptr};
  const NetcdfFile* second_file{nullptr};
  VelocityAxes axes{VelocityAxes::unstated};
  std::vector<std::string> warnings;  // what the choice means for the pilot
};

/// Files that are read together: the components of the velocity may be in different ones, and so may the tables
/// that place them.
using NetcdfFiles = std::vector<std::shared_ptr<const NetcdfFile>>;

/// Whether any variable claims to be a velocity of sea water, whether or not it can be used.
[[nodiscard]] bool holds_velocity(const NetcdfFile& file);

/// Which components a file holds.
enum class VelocityParts { none, first_alone, second_alone, both };
[[nodiscard]] VelocityParts velocity_parts(const NetcdfFile& file);

/// One of its components; null when it holds none.
[[nodiscard]] const NetcdfVariable* find_some_velocity(const NetcdfFile& file);

/// Chooses the pair by well-known names, then by standard names. Anomalies, wind, ice, waves and means over the
/// whole depth are never taken.
/// Errors   no velocity; one component alone
[[nodiscard]] Checked<VelocityPair> find_velocity_pair(const NetcdfFiles& files);

/// Metres per second in one of the variable's (unpacked) unit. A variable without a unit is taken as m/s and
/// says so in `warnings`; the size of its values has to confirm that.
[[nodiscard]] Checked<double> speed_factor_of(const NetcdfVariable& variable,
                                              std::vector<std::string>& warnings);

}  // namespace floeplan::ingest

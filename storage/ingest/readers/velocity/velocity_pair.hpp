#pragma once

#include <optional>
#include <string>
#include <vector>

#include "storage/ingest/common/refusal.hpp"
#include "storage/ingest/formats/netcdf/netcdf_file.hpp"
#include "storage/ingest/readers/velocity/velocity_kind.hpp"

namespace floeplan::ingest {

/// The two components of a velocity, in one file or in two.
struct VelocityPair {
  const NetcdfVariable* first{nullptr};  // towards east, or along the grid's first axis
  const NetcdfVariable* second{nullptr};
  const NetcdfFile* first_file{nullptr};
  const NetcdfFile* second_file{nullptr};
  Moving what{Moving::sea};
  VelocityAxes axes{VelocityAxes::unstated};
  WaterPart part{WaterPart::unstated};  // of currents without an axis of depth
  std::optional<double> depth_m;        // likewise, where a name states it
  Messages warnings;                    // what the choice means for the pilot
};

/// Whether any variable is a component of what moves that can be stored, alone or in a pair.
[[nodiscard]] bool holds_velocity(const NetcdfFile& file, Moving what,
                                  const WantedVariables& wanted = std::nullopt);

/// Whether the wanted variables are components of currents.
[[nodiscard]] bool names_velocity(const NetcdfFile& file, const WantedVariables& wanted);

/// Which components of currents a file holds.
enum class VelocityParts { none, first_alone, second_alone, both };
[[nodiscard]] VelocityParts velocity_parts(const NetcdfFile& file);

/// One of its components; null when it holds none.
[[nodiscard]] const NetcdfVariable* find_some_velocity(const NetcdfFile& file);

/// Why variables that claim to be velocities of what moves cannot be stored as such; empty where there are none.
[[nodiscard]] std::optional<messages::Message> velocities_left_out(const NetcdfFile& file, Moving what);

/// Chooses the pair: the whole current before a part of it, at levels before the surface and the mean over depth, by
/// well-known names before standard names alone. Statistics, anomalies and currents at the bed are never taken, the tide
/// alone and the drift by waves alone only where they are wanted. What else the file holds is told.
/// Errors   no velocity; one component alone; several pairs between which nothing decides; components that contradict
///          themselves or each other
[[nodiscard]] Checked<VelocityPair> find_velocity_pair(const NetcdfFiles& files, Moving what,
                                                       const WantedVariables& wanted = std::nullopt);

}  // namespace floeplan::ingest

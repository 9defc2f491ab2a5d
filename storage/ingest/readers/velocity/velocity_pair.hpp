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
  WaterPart part{WaterPart::unstated};  // for currents without a depth axis
  std::optional<double> depth_m;        // for currents without a depth axis whose name states the depth
  Messages warnings;                    // consequences of the choice, for the pilot
};

/// Whether a file has a component of a velocity that can be stored, single or in a pair.
[[nodiscard]] bool holds_velocity(const NetcdfFile& file, Moving what,
                                  const WantedVariables& wanted = std::nullopt);

/// Whether the variables that the user named are components of currents.
[[nodiscard]] bool names_velocity(const NetcdfFile& file, const WantedVariables& wanted);

/// The components of currents in a file.
enum class VelocityParts { none, first_alone, second_alone, both };
[[nodiscard]] VelocityParts velocity_parts(const NetcdfFile& file);

/// One component of the currents; null if there is none.
[[nodiscard]] const NetcdfVariable* find_some_velocity(const NetcdfFile& file);

/// Why variables that seem to be velocities of `what` cannot be stored; empty if there are none.
[[nodiscard]] std::optional<messages::Message> velocities_left_out(const NetcdfFile& file, Moving what);

/// Chooses the pair. Preferred are: the whole current to a part of it; currents at levels to those at the surface
/// or averaged over depth; well-known names to standard names alone. Statistics, anomalies and currents at the
/// bed are never chosen; the tide alone and the drift by waves alone only if the user names them. Warnings name
/// the pairs not chosen.
/// Errors   no velocity; a single component; several pairs of the same rank; components that contradict
///          themselves or each other
[[nodiscard]] Checked<VelocityPair> find_velocity_pair(const NetcdfFiles& files, Moving what,
                                                       const WantedVariables& wanted = std::nullopt);

}  // namespace floeplan::ingest

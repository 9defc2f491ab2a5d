#pragma once

#include <optional>
#include <string>
#include <vector>

#include "storage/ingest/common/refusal.hpp"
#include "storage/ingest/formats/netcdf/netcdf_file.hpp"

namespace floeplan::ingest {

/// The variables of sea ice in a file: estimates of its concentration (one for each method), and its
/// thickness or the draft of its level part.
struct IceVariables {
  std::vector<const NetcdfVariable*> concentrations;  // at least one, all on the same dimensions
  const NetcdfVariable* thickness{nullptr};           // null: none
  // draft: from the sea surface down to the underside of the ice
  bool thickness_is_draft{false};
  Messages warnings;
};

/// Whether any variable claims to be a concentration of sea ice.
[[nodiscard]] bool holds_ice(const NetcdfFile& file);

/// Whether any variable claims to be a thickness of sea ice.
[[nodiscard]] bool holds_ice_thickness(const NetcdfFile& file);

/// The message that a variable is a statistic of the concentration, not the concentration itself; empty if
/// the file has no such variable.
[[nodiscard]] std::optional<messages::Message> ice_left_out(const NetcdfFile& file);

/// Chooses the variables by standard name, then by well-known names. Statistics, uncertainties, flags, raw or
/// unfiltered estimates and lake ice are never chosen. `wanted` is the name of the only concentration to use.
/// Errors   no concentration, or none of the wanted name; a grid that this program does not read
[[nodiscard]] Checked<IceVariables> find_ice(const NetcdfFile& file,
                                             const std::optional<std::string>& wanted);

}  // namespace floeplan::ingest

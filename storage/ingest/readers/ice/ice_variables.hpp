#pragma once

#include <optional>
#include <string>
#include <vector>

#include "storage/ingest/common/refusal.hpp"
#include "storage/ingest/formats/netcdf/netcdf_file.hpp"

namespace floeplan::ingest {

/// What a file says of sea ice: estimates of its concentration (several where several methods were used) and its
/// thickness or the draft of its level part.
struct IceVariables {
  std::vector<const NetcdfVariable*> concentrations;  // at least one, all on the same dimensions
  const NetcdfVariable* thickness{nullptr};           // null: none
  bool thickness_is_draft{false};                     // from the surface of the sea to the underside
  Messages warnings;
};

/// Whether any variable claims to be a concentration of sea ice.
[[nodiscard]] bool holds_ice(const NetcdfFile& file);

/// Whether any variable claims to be a thickness of sea ice.
[[nodiscard]] bool holds_ice_thickness(const NetcdfFile& file);

/// Why a statistic of the concentration is none; empty where the file has no such statistic.
[[nodiscard]] std::optional<messages::Message> ice_left_out(const NetcdfFile& file);

/// Chooses by standard name, then by well-known names. Statistics, uncertainties, flags, raw and unfiltered estimates and
/// ice of lakes are never taken. `wanted` names one concentration to use alone.
/// Errors   no concentration, or none of the wanted name; a grid that this program does not read
[[nodiscard]] Checked<IceVariables> find_ice(const NetcdfFile& file,
                                             const std::optional<std::string>& wanted);

}  // namespace floeplan::ingest

#pragma once

#include <memory>
#include <string>
#include <vector>

#include "storage/ingest/bed_levels.hpp"
#include "storage/ingest/netcdf_file.hpp"
#include "storage/ingest/netcdf_layout.hpp"

namespace floeplan::ingest {

/// The sigma levels of a mesh at its nodes: shares of the way from the surface (0) to the bed (-1), from "siglay" and
/// the depth "h"; the surface from "zeta", or its mean with a warning where the file has none.
/// Errors   levels or depths that are missing or impossible
/// Source   CF conventions 1.8, appendix D, ocean_sigma_coordinate
[[nodiscard]] Checked<std::shared_ptr<const BedLevels>> sigma_levels(
    const std::shared_ptr<const NetcdfFile>& file, const NetcdfVariable& variable, const NetcdfLayout& layout,
    const std::string& node_dimension, std::vector<std::string>& warnings);

}  // namespace floeplan::ingest

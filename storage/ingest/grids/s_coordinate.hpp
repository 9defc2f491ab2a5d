#pragma once

#include <memory>
#include <string>
#include <vector>

#include "storage/ingest/formats/netcdf/netcdf_layout.hpp"
#include "storage/ingest/grids/bed_levels.hpp"
#include "storage/ingest/grids/centre_tables.hpp"

namespace floeplan::ingest {

/// The formulas by which models let their levels follow the sea bed.
enum class SCoordinate {
  g1,    // ROMS and CROCO, Vtransform 1
  g2,    // ROMS and CROCO, Vtransform 2
  sigma  // fractions of the depth from the surface to the bed; no stretching, no critical depth
};

/// Height of a level above the mean surface of the sea, metres (negative under water).
/// Source  CF conventions 1.8, appendix D, ocean_s_coordinate_g1, _g2 and ocean_sigma_coordinate
[[nodiscard]] double s_level_height_m(SCoordinate form, double s, double stretching, double critical_depth_m,
                                      double bed_depth_m, double surface_m);

/// The stretching curve at s in [-1, 0].
/// `form`   1: Song and Haidvogel 1994; 2: Shchepetkin 2005; 4: Shchepetkin 2010
/// Outside  nullopt for every other form
/// Source   Song and Haidvogel 1994, J. Comp. Phys. 115; ROMS documentation, "Vertical S-coordinate"
[[nodiscard]] std::optional<double> s_stretching(int form, double s, double theta_s, double theta_b);

/// The levels, at all centres of its grid, of a file with one of these formulas: ROMS, CROCO or any other
/// model on a regular or curvilinear grid. If the file has no free surface, the mean surface is used, with a
/// warning.
/// Errors   parameters that are missing or contradict each other
[[nodiscard]] Checked<std::shared_ptr<const BedLevels>> s_coordinate_levels(
    const NetcdfFiles& files, const NetcdfFile& file, const NetcdfVariable& variable,
    const NetcdfLayout& layout, const CentreTables& tables, Messages& warnings);

}  // namespace floeplan::ingest

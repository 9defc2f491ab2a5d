#pragma once

#include <optional>
#include <string>
#include <vector>

#include "storage/ingest/formats/netcdf/position_tables.hpp"
#include "storage/ingest/grids/staggering.hpp"
#include "storage/ingest/grids/water_mask.hpp"

namespace floeplan::ingest {

/// Finds and reads tables that a model has at the centres of its staggered grid (ROMS' rho points).
/// Shape  each table is [row][column], one value per cell centre of the staggered grid
class CentreTables {
 public:
  /// `variable` is the first component; if the components are collocated, its points are the centres.
  CentreTables(const Staggering& staggering, const NetcdfVariable& variable, PlaneDimensions plane);

  /// Whether the last two dimensions of `table` can be those of the cell centres.
  [[nodiscard]] bool fits(const NetcdfVariable& table) const;
  /// Reads the last two dimensions of a table, at the indices `leading` of its other dimensions. Scale is
  /// applied; NaN for the fill value and for centres that the table does not have.
  [[nodiscard]] Checked<std::vector<double>> read(const NetcdfVariable& table,
                                                  const std::vector<std::uint64_t>& leading) const;
  /// Angle of the grid's first axis at each cell centre, radians anticlockwise from east; empty if the file
  /// has none.
  [[nodiscard]] Checked<std::vector<double>> angle(const NetcdfFiles& files) const;
  [[nodiscard]] Checked<WaterMask> mask(const NetcdfFiles& files) const;

 private:
  [[nodiscard]] const NetcdfVariable* find(const NetcdfFiles& files, std::string_view name) const;

  Staggering staggering_;
  std::string y_name_;  // name of the dimension of the collocated points; empty when staggered
  std::string x_name_;
};

}  // namespace floeplan::ingest

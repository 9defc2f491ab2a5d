#pragma once

#include <optional>
#include <string>
#include <vector>

#include "storage/ingest/formats/netcdf/position_tables.hpp"
#include "storage/ingest/grids/staggering.hpp"
#include "storage/ingest/grids/water_mask.hpp"

namespace floeplan::ingest {

/// Finds and reads tables that a model has at the centres of its staggered grid (ROMS' rho points).
/// Shape  [row][column] of all centres of the staggering
class CentreTables {
 public:
  /// `variable` is the first component; if the components are collocated, its points are the centres.
  CentreTables(const Staggering& staggering, const NetcdfVariable& variable, PlaneDimensions plane);

  /// Whether a variable's last two dimensions can be those of the centres.
  [[nodiscard]] bool fits(const NetcdfVariable& table) const;
  /// Reads a table's last two dimensions at the indices `leading` of the others. Scale is applied; NaN for
  /// the fill value and for centres that the table does not have.
  [[nodiscard]] Checked<std::vector<double>> read(const NetcdfVariable& table,
                                                  const std::vector<std::uint64_t>& leading) const;
  /// Angle of the grid's first axis, radians anticlockwise from east; empty if the file has none.
  [[nodiscard]] Checked<std::vector<double>> angle(const NetcdfFiles& files) const;
  [[nodiscard]] Checked<WaterMask> mask(const NetcdfFiles& files) const;

 private:
  [[nodiscard]] const NetcdfVariable* find(const NetcdfFiles& files, std::string_view name) const;

  Staggering staggering_;
  std::string y_name_;  // name of the dimension of the collocated points; empty when staggered
  std::string x_name_;
};

}  // namespace floeplan::ingest

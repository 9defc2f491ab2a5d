#pragma once

#include <optional>
#include <string>
#include <vector>

#include "storage/ingest/formats/netcdf/position_tables.hpp"
#include "storage/ingest/grids/staggering.hpp"
#include "storage/ingest/grids/water_mask.hpp"

namespace floeplan::ingest {

/// Finds what a model states at the centres of its staggered grid (ROMS' rho points).
/// Shape  [row][column] of all centres of the staggering
class CentreTables {
 public:
  /// `variable` is the first component; where the components are collocated its plane is that of the centres.
  CentreTables(const Staggering& staggering, const NetcdfVariable& variable, PlaneDimensions plane);

  /// Whether a variable's last two dimensions can be those of the centres.
  [[nodiscard]] bool fits(const NetcdfVariable& table) const;
  /// The plane of a table with its leading dimensions at `leading` (one index each), scale applied, fill as NaN, as is
  /// what the table does not reach.
  [[nodiscard]] Checked<std::vector<double>> read(const NetcdfVariable& table,
                                                  const std::vector<std::uint64_t>& leading) const;
  /// Angle of the grid's first axis, radians counterclockwise from east; empty where the file has none.
  [[nodiscard]] Checked<std::vector<double>> angle(const NetcdfFiles& files) const;
  [[nodiscard]] Checked<WaterMask> mask(const NetcdfFiles& files) const;

 private:
  [[nodiscard]] const NetcdfVariable* find(const NetcdfFiles& files, std::string_view name) const;

  Staggering staggering_;
  std::string y_name_;  // of the collocated plane; empty when staggered
  std::string x_name_;
};

}  // namespace floeplan::ingest

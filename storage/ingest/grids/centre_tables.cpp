#include "storage/ingest/grids/centre_tables.hpp"

#include <algorithm>
#include <limits>
#include <numbers>

#include "engine/messages/ingest_grid_messages.hpp"
#include "storage/ingest/notation/text.hpp"

namespace floeplan::ingest {

CentreTables::CentreTables(const Staggering& staggering, const NetcdfVariable& variable,
                           PlaneDimensions plane)
    : staggering_{staggering} {
  if (!staggering.collocated) return;
  y_name_ = variable.dimensions()[plane.y].name;
  x_name_ = variable.dimensions()[plane.x].name;
}

bool CentreTables::fits(const NetcdfVariable& table) const {
  const auto& dimensions = table.dimensions();
  if (!table.is_numeric() || dimensions.size() < 2) return false;
  const NetcdfDimension& y = dimensions[dimensions.size() - 2];
  const NetcdfDimension& x = dimensions.back();
  if (staggering_.collocated)
    return y.name == y_name_ && x.name == x_name_ && y.size == staggering_.rows &&
           x.size == staggering_.columns;
  // Names of the dimensions of ROMS' centres. They may have one more row and column on each side, or be cut
  // on one side.
  return lower(y.name) == "eta_rho" && lower(x.name) == "xi_rho" &&
         y.size >= staggering_.rows + staggering_.first_row &&
         x.size >= staggering_.columns + staggering_.second_column;
}

Checked<std::vector<double>> CentreTables::read(const NetcdfVariable& table,
                                                const std::vector<std::uint64_t>& leading) const {
  const auto& dimensions = table.dimensions();
  if (leading.size() + 2 != dimensions.size())
    return refuse(messages::ingest_grid_message<"table-of-other-dimensions">(table.name()));
  const std::size_t rows = std::min<std::size_t>(dimensions[leading.size()].size, staggering_.all_rows);
  const std::size_t columns = std::min<std::size_t>(dimensions.back().size, staggering_.all_columns);
  std::vector<std::uint64_t> start = leading;
  start.insert(start.end(), 2, 0);
  std::vector<std::size_t> count(leading.size(), 1);
  count.insert(count.end(), {rows, columns});
  const auto values = table.read_packed(start, count);
  if (!values) return refuse(values.error());
  std::vector<double> plane(staggering_.all_rows * staggering_.all_columns,
                            std::numeric_limits<double>::quiet_NaN());
  for (std::size_t row = 0; row < rows; ++row)
    for (std::size_t column = 0; column < columns; ++column)
      plane[row * staggering_.all_columns + column] = table.unpacked((*values)[row * columns + column]);
  return plane;
}

const NetcdfVariable* CentreTables::find(const NetcdfFiles& files, std::string_view name) const {
  for (const auto& file : files)
    for (const NetcdfVariable& table : file->variables())
      if (lower(table.name()) == name && table.dimensions().size() == 2 && fits(table)) return &table;
  return nullptr;
}

Checked<std::vector<double>> CentreTables::angle(const NetcdfFiles& files) const {
  const NetcdfVariable* table = find(files, "angle");
  if (table == nullptr) return std::vector<double>{};
  auto values = read(*table, {});
  if (values && contains_any(lower(table->attribute("units")), {"degree"}))
    for (double& value : *values) value *= std::numbers::pi / 180.0;
  return values;
}

Checked<WaterMask> CentreTables::mask(const NetcdfFiles& files) const {
  const NetcdfVariable* table = find(files, "mask_rho");
  if (table == nullptr) return WaterMask{};
  const auto values = read(*table, {});
  if (!values) return refuse(values.error());
  return WaterMask{water_of(*values)};
}

}  // namespace floeplan::ingest

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/units.hpp"

namespace floeplan::codec {

/// A regular grid in degrees with one or more variables, for the map client.
/// Shape  values are [y][x], row 0 in the south, columns from west to east; a missing value is empty
struct MapGrid {
  struct Variable {
    std::string name;  // with its unit: "depth_m"
    double scale{};    // value of one step of the encoded numbers
    std::vector<std::optional<double>> values;
  };

  std::size_t nx{};
  std::size_t ny{};
  double west_deg{};
  double south_deg{};
  double dx_deg{};
  double dy_deg{};
  std::optional<core::UtcTime> time;
  std::string dataset_id;
  std::string dataset_name;
  std::vector<std::string> warnings;
  std::vector<Variable> variables;
};

/// Encodes the grid: uint32 length of the header; the header as JSON, padded with blanks so that length and
/// header together are a multiple of eight bytes; then the int16 values, variable by variable. All
/// little-endian; -32768 means missing.
[[nodiscard]] std::string encode(const MapGrid& grid);

}  // namespace floeplan::codec

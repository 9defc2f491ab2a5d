#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/units.hpp"

namespace floeplan::codec {

/// A regular grid of degrees with one or more variables, for the map.
/// Shape  values are [y][x], row 0 in the south, columns from west to east; empty where nothing is known
struct MapGrid {
  struct Variable {
    std::string name;  // with its unit: "depth_m"
    double scale{};    // the encoded steps
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

/// The grid as bytes: uint32 length of the header, header as JSON padded with blanks so that length and
/// header make a multiple of eight, then int16 values variable by variable, all little-endian; missing is
/// -32768.
[[nodiscard]] std::string encode(const MapGrid& grid);

}  // namespace floeplan::codec

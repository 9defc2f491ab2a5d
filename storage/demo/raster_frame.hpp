#pragma once

#include <cstddef>

#include "engine/geo/lon_lat.hpp"

namespace floeplan::demo {

/// A grid regular in longitude and latitude. Values belong to cell centres; row 0 lies in the south.
/// Shape    arrays over it are [row][column], column fastest
struct RasterFrame {
  double west_deg{};  // outer edges of the first cell
  double south_deg{};
  double step_lon_deg{};
  double step_lat_deg{};
  std::size_t columns{};
  std::size_t rows{};

  [[nodiscard]] std::size_t size() const { return columns * rows; }
  [[nodiscard]] std::size_t index(std::size_t column, std::size_t row) const {
    return row * columns + column;
  }
  [[nodiscard]] double lon_deg(std::size_t column) const {
    return west_deg + (static_cast<double>(column) + 0.5) * step_lon_deg;
  }
  [[nodiscard]] double lat_deg(std::size_t row) const {
    return south_deg + (static_cast<double>(row) + 0.5) * step_lat_deg;
  }
  [[nodiscard]] geo::LonLat centre(std::size_t column, std::size_t row) const {
    return {lon_deg(column), lat_deg(row)};
  }
  [[nodiscard]] geo::LonLat centre(std::size_t at) const { return centre(at % columns, at / columns); }
};

}  // namespace floeplan::demo

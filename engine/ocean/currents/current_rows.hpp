#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "engine/ocean/currents/current_grid.hpp"

namespace floeplan::ocean {

/// Some rows of a grid of currents at one time step, at all levels, with the tide and the added current if the grid
/// has them.
/// Shape    u and v are [level][row][column], m/s towards true east and true north; the levels begin
///          `level_stride` samples apart. NaN if a sample or the tide is missing
/// Threads  const members may be called from several threads at once
class CurrentRows {
 public:
  /// `currents` is borrowed and must outlive the rows. Precondition: the grid has all these rows.
  CurrentRows(const CurrentGrid& currents, std::size_t time_index, std::size_t first_row, std::size_t rows);
  CurrentRows(const CurrentRows&) = delete;
  CurrentRows& operator=(const CurrentRows&) = delete;

  [[nodiscard]] std::span<const float> u() const { return u_; }
  [[nodiscard]] std::span<const float> v() const { return v_; }
  [[nodiscard]] std::size_t levels() const { return levels_; }
  [[nodiscard]] std::size_t columns() const { return columns_; }
  [[nodiscard]] std::size_t level_stride() const { return level_stride_; }

 private:
  void add_to_samples(const CurrentGrid& currents, std::size_t time_index, std::size_t first_row);
  void add_tide(const CurrentGrid& currents, std::size_t time_index, std::size_t first_row);

  std::size_t levels_;
  std::size_t columns_;
  std::size_t level_stride_;
  std::vector<float> summed_u_;  // with tide and added current; empty if the grid has none
  std::vector<float> summed_v_;
  std::span<const float> u_;
  std::span<const float> v_;
};

}  // namespace floeplan::ocean

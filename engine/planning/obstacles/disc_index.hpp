#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/planning/plane/plane_box.hpp"
#include "engine/planning/problem/time_span.hpp"

namespace floeplan::planning::obstacles {

/// Finds the items (pieces of discs) that may be in a box during a time: a grid over the plane for each slot
/// of time. Items outside its area and period are kept in the outermost cells, so none is ever missed.
/// Threads  const members may be called from several threads at once
class DiscIndex {
 public:
  /// An item, with a box that contains it during a period.
  struct Entry {
    std::uint32_t item{};
    plane::PlaneBox box;
    TimeSpan span{};
  };

  DiscIndex() = default;
  /// `cell_m`: about the size of the items. `slot`: time in which they move about this distance.
  DiscIndex(const plane::PlaneBox& area, double cell_m, core::Seconds slot, core::Seconds horizon,
            const std::vector<Entry>& entries);

  /// Calls `visit(item)` for every item that may be in the box during the span; some items are visited more
  /// than once. Ends with true as soon as `visit` returns true.
  template <class Visit>
  bool any_in(const plane::PlaneBox& box, const TimeSpan& span, const Visit& visit) const {
    if (items_.empty()) return false;
    const Cells cells = cells_of(box, span);
    for (std::int64_t slot = cells.first_slot; slot <= cells.last_slot; ++slot) {
      for (std::int64_t row = cells.first_row; row <= cells.last_row; ++row) {
        const std::size_t begin = cell(cells.first_column, row, slot);
        const std::size_t end = cell(cells.last_column, row, slot) + 1;
        for (std::size_t i = first_[begin]; i < first_[end]; ++i) {
          if (visit(items_[i])) return true;
        }
      }
    }
    return false;
  }

  [[nodiscard]] std::size_t bytes() const { return (first_.size() + items_.size()) * sizeof(std::uint32_t); }

 private:
  struct Cells {
    std::int64_t first_column, last_column, first_row, last_row, first_slot, last_slot;
  };
  [[nodiscard]] Cells cells_of(const plane::PlaneBox& box, const TimeSpan& span) const {
    return {place(box.low.x_m - area_.low.x_m, cell_m_, columns_),
            place(box.high.x_m - area_.low.x_m, cell_m_, columns_),
            place(box.low.y_m - area_.low.y_m, cell_m_, rows_),
            place(box.high.y_m - area_.low.y_m, cell_m_, rows_),
            place(span.from.count(), slot_s_, slots_),
            place(span.until.count(), slot_s_, slots_)};
  }
  [[nodiscard]] static std::int64_t place(double value, double step, std::int64_t count) {
    return static_cast<std::int64_t>(
        std::clamp(std::floor(value / step), 0.0, static_cast<double>(count - 1)));
  }
  [[nodiscard]] std::size_t cell(std::int64_t column, std::int64_t row, std::int64_t slot) const {
    return static_cast<std::size_t>((slot * rows_ + row) * columns_ + column);
  }

  plane::PlaneBox area_;
  double cell_m_{1.0};
  double slot_s_{1.0};
  std::int64_t columns_{1};
  std::int64_t rows_{1};
  std::int64_t slots_{1};
  std::vector<std::uint32_t> first_;  // index of each cell's items, [slot][row][column], and the end
  std::vector<std::uint32_t> items_;
};

}  // namespace floeplan::planning::obstacles

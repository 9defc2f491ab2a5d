#include "engine/planning/obstacles/disc_index.hpp"

namespace floeplan::planning::obstacles {
namespace {

std::int64_t steps(double length, double step) {
  return std::max<std::int64_t>(1, static_cast<std::int64_t>(std::ceil(length / step)));
}

}  // namespace

DiscIndex::DiscIndex(const plane::PlaneBox& area, double cell_m, core::Seconds slot, core::Seconds horizon,
                     const std::vector<Entry>& entries)
    : area_{area},
      cell_m_{cell_m},
      slot_s_{slot.count()},
      columns_{steps(area.width_m(), cell_m)},
      rows_{steps(area.height_m(), cell_m)},
      slots_{steps(horizon.count(), slot.count()) + 1},  // the last slot has no end
      first_(static_cast<std::size_t>(columns_ * rows_ * slots_) + 1, 0) {
  const auto for_each_cell = [&](const Entry& entry, const auto& visit) {
    const Cells cells = cells_of(entry.box, entry.span);
    for (std::int64_t slot_number = cells.first_slot; slot_number <= cells.last_slot; ++slot_number) {
      for (std::int64_t row = cells.first_row; row <= cells.last_row; ++row) {
        for (std::int64_t column = cells.first_column; column <= cells.last_column; ++column) {
          visit(cell(column, row, slot_number));
        }
      }
    }
  };
  for (const Entry& entry : entries) for_each_cell(entry, [&](std::size_t i) { ++first_[i + 1]; });
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  items_.resize(first_.back());
  std::vector<std::uint32_t> next{first_.begin(), first_.end() - 1};
  for (const Entry& entry : entries)
    for_each_cell(entry, [&](std::size_t i) { items_[next[i]++] = entry.item; });
}

}  // namespace floeplan::planning::obstacles

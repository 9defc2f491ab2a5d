#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace floeplan::planning::plane {

/// A cell between two neighbouring nodes, and the position in it as a share of its width, in [0, 1].
struct CellPosition {
  std::size_t cell{};
  double share{};
};

/// Ascending nodes for inner loops: equally spaced nodes are found by one multiplication, others by
/// bisection. With a single node there is no cell, so nothing is found. Precondition: at least one node,
/// strictly ascending.
class FastAxis {
 public:
  explicit FastAxis(std::vector<double> nodes) : nodes_{std::move(nodes)} {
    if (nodes_.size() < 2) return;
    const double step = (nodes_.back() - nodes_.front()) / static_cast<double>(nodes_.size() - 1);
    inverse_step_ = 1.0 / step;
    for (std::size_t i = 1; i < nodes_.size(); ++i)
      inverse_widths_.push_back(1.0 / (nodes_[i] - nodes_[i - 1]));
    uniform_ = true;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      uniform_ =
          uniform_ && std::abs(nodes_[i] - (nodes_.front() + step * static_cast<double>(i))) <= slack * step;
    }
  }

  /// Outside  nullopt below the first node and above the last one, with a tolerance for rounding errors
  [[nodiscard]] std::optional<CellPosition> locate(double value) const {
    if (nodes_.size() < 2) return std::nullopt;
    const std::size_t last_cell = nodes_.size() - 2;
    if (uniform_) {
      const double index = (value - nodes_.front()) * inverse_step_;
      if (!(index >= -slack && index <= static_cast<double>(last_cell + 1) + slack)) return std::nullopt;
      const auto cell = std::min(static_cast<std::size_t>(std::max(index, 0.0)), last_cell);
      return CellPosition{cell, std::clamp(index - static_cast<double>(cell), 0.0, 1.0)};
    }
    if (!(value >= nodes_.front() && value <= nodes_.back())) return std::nullopt;
    const auto above = std::upper_bound(nodes_.begin(), nodes_.end(), value);
    const auto cell = std::min(static_cast<std::size_t>(above - nodes_.begin()) - 1, last_cell);
    return CellPosition{cell, (value - nodes_[cell]) * inverse_widths_[cell]};
  }

  [[nodiscard]] double mean_step() const { return 1.0 / inverse_step_; }
  [[nodiscard]] double inverse_width(std::size_t cell) const { return inverse_widths_[cell]; }
  [[nodiscard]] std::size_t size() const { return nodes_.size(); }
  [[nodiscard]] const std::vector<double>& nodes() const { return nodes_; }

 private:
  static constexpr double slack = 1e-6;  // share of a step: rounding error of float32 coordinates

  std::vector<double> nodes_;
  std::vector<double> inverse_widths_;  // of the cells
  double inverse_step_{};
  bool uniform_{false};
};

}  // namespace floeplan::planning::plane

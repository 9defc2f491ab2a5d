#include "engine/ocean/grids/axis.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace floeplan::ocean {
namespace {

constexpr double node_tolerance =
    1e-6;  // of a step: the rounding of float32 coordinates, far below their spacing

}  // namespace

Axis::Axis(std::vector<double> nodes) : nodes_{std::move(nodes)} {
  if (nodes_.empty()) throw std::invalid_argument{"an axis needs at least one node"};
  if (!std::ranges::all_of(nodes_, [](double node) { return std::isfinite(node); })) {
    throw std::invalid_argument{"an axis needs finite nodes"};
  }
  if (std::ranges::adjacent_find(nodes_, std::greater_equal{}) != nodes_.end()) {
    throw std::invalid_argument{"the nodes of an axis must ascend strictly"};
  }
  const double step = mean_step();
  uniform_ = nodes_.size() > 2;
  for (std::size_t i = 0; i < nodes_.size() && uniform_; ++i) {
    uniform_ = std::abs(nodes_[i] - (nodes_.front() + step * static_cast<double>(i))) < 0.01 * step;
  }
}

double Axis::mean_step() const {
  if (nodes_.size() < 2) return 0.0;
  return (nodes_.back() - nodes_.front()) / static_cast<double>(nodes_.size() - 1);
}

std::optional<AxisPosition> Axis::locate(double value) const {
  const std::size_t last = nodes_.size() - 1;
  const double slack = node_tolerance * (last > 0 ? mean_step() : std::max(1.0, std::abs(nodes_.front())));
  if (!(value >= nodes_.front() - slack && value <= nodes_.back() + slack)) return std::nullopt;

  std::size_t lower = 0;
  if (uniform_) {
    // First guess by division. The true interval is at most one further, because nodes deviate from even
    // steps by less than 1 %.
    const double guess = (value - nodes_.front()) / mean_step();
    lower = static_cast<std::size_t>(std::clamp(guess, 0.0, static_cast<double>(last)));
    if (lower > 0 && value < nodes_[lower]) --lower;
    if (lower < last && value >= nodes_[lower + 1]) ++lower;
  } else {
    const auto above = std::ranges::upper_bound(nodes_, value);
    lower = above == nodes_.begin() ? 0 : static_cast<std::size_t>(above - nodes_.begin()) - 1;
  }
  if (lower == last) return AxisPosition{last, last, 0.0};

  const double fraction = (value - nodes_[lower]) / (nodes_[lower + 1] - nodes_[lower]);
  if (fraction <= node_tolerance) return AxisPosition{lower, lower, 0.0};
  if (fraction >= 1.0 - node_tolerance) return AxisPosition{lower + 1, lower + 1, 0.0};
  return AxisPosition{lower, lower + 1, fraction};
}

}  // namespace floeplan::ocean

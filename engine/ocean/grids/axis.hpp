#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace floeplan::ocean {

/// Position of a value between two neighbouring nodes: `lower + fraction`, fraction in [0, 1).
struct AxisPosition {
  std::size_t lower{};
  std::size_t upper{};  // equals lower if the value is exactly a node
  double fraction{};    // position from lower to upper, as a share
};

/// Coordinates of the nodes along one dimension of a grid, strictly ascending; steps may differ.
/// Errors   std::invalid_argument from the constructor when empty, not finite or not strictly ascending
/// Threads  const members may be called from several threads at once
class Axis {
 public:
  explicit Axis(std::vector<double> nodes);

  [[nodiscard]] std::size_t size() const { return nodes_.size(); }
  [[nodiscard]] double front() const { return nodes_.front(); }
  [[nodiscard]] double back() const { return nodes_.back(); }
  [[nodiscard]] double operator[](std::size_t i) const { return nodes_[i]; }
  [[nodiscard]] const std::vector<double>& nodes() const { return nodes_; }
  /// Mean distance between neighbouring nodes; 0 for a single node.
  [[nodiscard]] double mean_step() const;

  /// Outside  nullopt below the first and above the last node. A value within 1e-6 of a step from a node
  ///          counts as that node
  [[nodiscard]] std::optional<AxisPosition> locate(double value) const;

 private:
  std::vector<double> nodes_;
  bool uniform_{false};
};

}  // namespace floeplan::ocean

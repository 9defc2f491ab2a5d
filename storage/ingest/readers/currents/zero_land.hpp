#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace floeplan::ingest {

/// Finds land that a model wrote as still water, as NEMO and POP do: nodes where both components are exactly
/// zero at all times and that form a large patch, in a field without any missing node.
/// Shape    slices are [y][x], last index fastest
class ZeroLand {
 public:
  ZeroLand(std::size_t columns, std::size_t rows, std::size_t levels);

  /// Adds one slice of one time; NaN marks a missing sample.
  void add(std::size_t level, std::span<const float> u, std::span<const float> v);

  [[nodiscard]] bool everything_is_zero() const;
  /// Whether the nodes that are always zero are land.
  [[nodiscard]] bool found() const;
  [[nodiscard]] bool is_land(std::size_t level, std::size_t node) const {
    return zero_[level * nodes_ + node];
  }
  /// Share of nodes of the uppermost level that are always zero.
  [[nodiscard]] double share() const;

 private:
  [[nodiscard]] std::size_t largest_patch() const;

  std::size_t columns_;
  std::size_t nodes_;
  std::vector<bool> zero_;  // [level][node]
  bool any_missing_{false};
};

}  // namespace floeplan::ingest

#pragma once

#include <optional>
#include <vector>

#include "engine/motion/plane_current.hpp"
#include "engine/ocean/current_grid.hpp"
#include "engine/planning/fast_axis.hpp"
#include "engine/planning/node_window.hpp"
#include "engine/vehicle/dive_band.hpp"

namespace floeplan::planning {

/// Turns vectors from east and north into the axes of the plane, at one node.
struct NodeTurn {
  double cosine{1.0};
  double sine{};
};

/// The currents of a window of nodes at one time.
/// Coast  a node without water takes the mean of its neighbours with water, one ring deep, because a model's
///        land mask is coarser than the coast
class CurrentSlice {
 public:
  struct Mean {
    motion::CurrentXy current;
    bool extended{false};  // it rests on a node beyond the data's own coast
  };

  /// `currents`, `window` and `turns` (one for each node, [y][x]) are borrowed and outlive the slice.
  CurrentSlice(const ocean::CurrentGrid& currents, const NodeWindow& window,
               const std::vector<NodeTurn>& turns, std::size_t time_index);

  /// Mean over the depths of the band, each node's column by itself, bilinear between the nodes; empty where
  /// there is no water.
  [[nodiscard]] std::optional<Mean> mean(const CellPosition& x, const CellPosition& y,
                                         const vehicle::DiveBand& band);

 private:
  /// What a node answered last: places beside each other mostly ask for the same band.
  struct Answer {
    vehicle::DiveBand band;
    std::optional<Mean> mean;
  };
  [[nodiscard]] const std::optional<Mean>& at_node(std::size_t ix, std::size_t iy,
                                                   const vehicle::DiveBand& band);
  [[nodiscard]] std::optional<Mean> worked_out(std::size_t ix, std::size_t iy,
                                               const vehicle::DiveBand& band) const;
  /// Empty where the node itself has no water.
  [[nodiscard]] std::optional<motion::CurrentXy> turned(std::size_t ix, std::size_t iy,
                                                        const vehicle::DiveBand& band) const;

  const ocean::CurrentGrid& currents_;
  const NodeWindow& window_;
  const std::vector<NodeTurn>& turns_;
  std::size_t time_index_;
  std::vector<std::optional<Answer>> answers_;  // [y][x]
};

}  // namespace floeplan::planning
